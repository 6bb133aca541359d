# For scripts that run many checks: goes on after a failure, lists each check with its time, fails if one failed.
# Without uncommitted changes, what passed on this commit (build/checks-COMMIT) is not run again.
# shellcheck shell=bash
times="" failed=0 record=""
if commit=$(git rev-parse HEAD) && [ -z "$(git status --porcelain)" ]; then
  mkdir -p build
  record=build/checks-$commit
fi

check() {  # COMMAND...
  local status=0 began=$SECONDS before=""
  printf '\n== %s\n' "$*"
  [ ! -f "$record" ] || before=$(awk -F'\t' -v command="$*" '$2 == command { print $1; exit }' "$record")
  if [ -n "$before" ]; then
    times+=$(printf '%-70s %6d s  passed before' "$*" "$before")$'\n'
    return
  fi
  "$@" || status=$?
  if [ "$status" -ne 0 ]; then
    failed=1
  elif [ -n "$record" ]; then
    printf '%d\t%s\n' $((SECONDS - began)) "$*" >> "$record"
  fi
  times+=$(printf '%-70s %6d s  %s' "$*" $((SECONDS - began)) "$([ "$status" -eq 0 ] && echo passed || echo "failed ($status)")")$'\n'
}

end_of_checks() {
  printf '\n%s%-70s %6d s\n' "$times" all "$SECONDS"
  exit "$failed"
}
