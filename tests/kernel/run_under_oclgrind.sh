#!/bin/sh
# run_under_oclgrind.sh [--ignore-uninitialized] PROGRAM [ARGUMENT...]: fails when the program does, and when Oclgrind finds an
# access out of bounds, a data race, a use of an uninitialised value (unless that is ignored) or a wrong API call. Oclgrind's exit
# status says nothing of these: what it prints does. (Not its --log: each context of a program begins that anew.) Kernels are
# compiled without optimisation and inlining, because Oclgrind 21.10 does not know all that clang makes of them.
uninitialized=--uninitialized
if [ "$1" = --ignore-uninitialized ]; then
  uninitialized=
  shift
fi
if ! command -v oclgrind >/dev/null; then
  echo "SKIPPED: kernel tests under Oclgrind: oclgrind is not installed"
  exit 0
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# shellcheck disable=SC2086 # nothing, or one word
oclgrind --check-api --data-races $uninitialized --build-options "-O0 -D ALWAYS_INLINE=" "$@" 2>"$log"
status=$?
if [ -s "$log" ]; then
  echo "Oclgrind found, or the program told:"
  head -n 60 "$log"
  exit 1
fi
exit $status
