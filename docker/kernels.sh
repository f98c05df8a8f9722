#!/bin/sh
# kernels.sh PREFIX MODELS: compiles the sampling kernels of the captra in PREFIX, as loading MODELS needs them.
set -eu
prefix=$1 models=$2
. "$prefix/bin/processor.sh"
for name in $(processors); do
    [ "$name" = "$(processor)" ] || [ "$name" != x86-64-v3 ] || continue  # this machine could not run it
    NUMBA_CACHE_DIR="$prefix/kernels" NUMBA_CPU_NAME=$name NUMBA_CPU_FEATURES='' "$prefix/bin/python" - "$models" <<'PYTHON'
import sys
from pathlib import Path

from service.bundles import BundleNetworks

BundleNetworks(Path(sys.argv[1]), "realtime", "cpu", None).prepare()
PYTHON
done
