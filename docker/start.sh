#!/bin/sh
# start.sh ARGUMENTS...: `captra ARGUMENTS...` with the kernels that were compiled when the image was built.
set -eu
prefix=$(dirname "$(dirname "$(readlink -f "$0")")")
. "$prefix/bin/processor.sh"
NUMBA_CPU_NAME=$(processor) NUMBA_CPU_FEATURES=''
export NUMBA_CPU_NAME NUMBA_CPU_FEATURES
# Numba reads machine code only from a folder that it may write to. Without one it compiles in memory, which takes longer.
if copy=$(mktemp -d 2>/dev/null) && cp -r "$prefix/kernels" "$copy"; then
    export NUMBA_CACHE_DIR="$copy/kernels"
fi
exec "$prefix/bin/captra" "$@"
