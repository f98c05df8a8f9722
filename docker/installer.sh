#!/bin/sh
# What installs packages; stays in the stage that builds. As root.
set -eu
apt-get update
apt-get install --yes --no-install-recommends python3-pip python3-venv
rm -rf /var/lib/apt/lists/* /var/cache/apt/*
