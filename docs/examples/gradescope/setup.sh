#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image.
set -euo pipefail
apt-get update -qq
apt-get install -y -qq --no-install-recommends "${AUTOGRADER:-/autograder}"/source/scenefile_*.deb python3
