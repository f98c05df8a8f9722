#!/bin/sh
# packages.sh SOURCE RUNTIME PREFIX: captra and what it needs at run time, in a virtual environment without pip.
# RUNTIME is cpu, openvino or gpu: the build of ONNX Runtime. What a guarded service needs is among it, PyTorch and a C
# compiler are not.
set -eu
source=$1 runtime=$2 prefix=$3
case $runtime in
    cpu | openvino | gpu) ;;
    *) echo "RUNTIME is $runtime, but has to be cpu, openvino or gpu" >&2; exit 2 ;;
esac
python3 -m venv --without-pip "$prefix"
python3 -m pip --python "$prefix/bin/python" install --no-cache-dir --disable-pip-version-check "$source[$runtime,secure]"
# Tests of the packages, of no use in an image.
find "$prefix/lib" -type d -name tests -path '*/site-packages/*' -prune -exec rm -rf {} +
if [ -e "$prefix"/lib/python3*/site-packages/torch ]; then
    echo "PyTorch has come along: check the dependencies of captra[$runtime]" >&2
    exit 1
fi
install -m 755 "$source/docker/start.sh" "$source/docker/processor.sh" "$prefix/bin/"
