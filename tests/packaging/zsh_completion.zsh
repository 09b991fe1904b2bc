# SPDX-License-Identifier: GPL-3.0-or-later
# Read by a zsh on a terminal (shells_test.py): Tab prints what would be offered, one a line after HIT:, and ends it.
PROMPT=
fpath=($COMPLETIONS $fpath)
autoload -Uz compinit
# What the first of them finds the next ones read.
compinit -C -d $HOME/dump
bindkey '^I' complete-word
zstyle ':completion:*' insert-tab false
compadd() {
    local -a hits
    # Calls that only ask for what matches are left alone.
    if [[ ${argv[1,(i)(-|--)]} == *-[a-zA-Z]#[OAD]* ]]; then
        builtin compadd "$@"
        return
    fi
    builtin compadd -A hits "$@"
    print -rl -- HIT:$^hits
    builtin compadd "$@"
}
end_here() { print END; exit }
comppostfuncs=(end_here)
print READY
