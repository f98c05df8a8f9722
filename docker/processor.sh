#!/bin/sh
# The processors that kernels are compiled for. Machine code is kept under the processor's name: a few names that many
# machines share make it that what an image was built with is found wherever it runs.

# All names for this architecture.
processors() {
    case $(uname -m) in
        x86_64) echo "x86-64-v3 x86-64" ;;
        *) echo generic ;;
    esac
}

# The best one that this machine can run.
processor() {
    [ "$(uname -m)" = x86_64 ] || { echo generic; return; }
    flags=" $(grep -m 1 '^flags' /proc/cpuinfo) "
    for flag in avx2 bmi1 bmi2 f16c fma abm movbe; do
        case $flags in *" $flag "*) ;; *) echo x86-64; return ;; esac
    done
    echo x86-64-v3
}
