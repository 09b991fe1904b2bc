# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Read by a bash on a terminal (shells_test.py): Control-G tells the line as it has become, and ends it.
PS1=
# shellcheck source=/dev/null
source "$COMPLETIONS/psicarve"
bind 'set completion-query-items 0'
bind 'set bell-style none'
# shellcheck disable=SC2016 # its line, when the key is pressed
bind -x '"\C-g": printf "\nLINE<%s>\nEND\n" "$READLINE_LINE"; exit'
echo READY
