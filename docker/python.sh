#!/bin/sh
# Python, from the distribution, so that its security updates reach the image. As root.
set -eu
apt-get update
apt-get install --yes --no-install-recommends python3
rm -rf /var/lib/apt/lists/* /var/cache/apt/*
