#!/bin/sh
# user.sh STATE: the user that the service runs as, with the one folder that it may write to. As root.
set -eu
useradd --uid 10001 --user-group --no-create-home --shell /usr/sbin/nologin captra
install -d -o captra -g captra -m 700 "$1"
