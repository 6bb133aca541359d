# For scripts that run many checks: goes on after a failure, lists each check with its time, fails if one failed.
# shellcheck shell=bash
times="" failed=0

check() {  # COMMAND...
  local status=0 began=$SECONDS
  printf '\n== %s\n' "$*"
  "$@" || status=$?
  [ "$status" -eq 0 ] || failed=1
  times+=$(printf '%-70s %6d s  %s' "$*" $((SECONDS - began)) "$([ "$status" -eq 0 ] && echo passed || echo "failed ($status)")")$'\n'
}

end_of_checks() {
  printf '\n%s%-70s %6d s\n' "$times" all "$SECONDS"
  exit "$failed"
}
