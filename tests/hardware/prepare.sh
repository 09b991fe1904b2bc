#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes what QEMU boots: Debian's PREEMPT_RT kernel, downloaded and unpacked (never installed), and an initial
# file system with the kernel's port drivers, the programs under test and every library that they name.
#   prepare.sh CACHE OUTPUT INIT FILE... -- PROGRAM...
# CACHE may be shared by all builds of a user: a kernel stays there until there is a newer one.
# OUTPUT/vmlinuz and OUTPUT/initramfs; FILEs stand in the root folder there, PROGRAMs in /bin.
set -euo pipefail

cache=$1
output=$2
init=$3
shift 3
fail() { printf 'hardware: %s\n' "$1" >&2; exit 1; }
for tool in qemu-system-x86_64 busybox cpio apt-get dpkg-deb; do
    command -v "$tool" >/dev/null || fail "no $tool here; scripts/deps.sh test, or PSICARVE_SKIP_HARDWARE=1"
done

kernel_package() { apt-cache depends linux-image-rt-amd64 2>/dev/null | awk '/Depends:/ && !found {print $2; found = 1}'; }
download_kernel() {
    local name
    name=$(kernel_package) && [[ -n $name ]] && (cd "$cache" && apt-get -qq download "$name")
}

mkdir -p "$cache" "$output"
exec 9>"$cache/lock"
flock 9
# The name of the package that is unpacked there.
unpacked=$(cat "$cache/kernel/complete" 2>/dev/null) || true
package=$(kernel_package) || true  # nothing where the lists are missing
if [[ -z $unpacked || (-n $package && $package != "$unpacked") ]]; then
    rm -f "$cache"/*.deb
    is_here=true
    if ! download_kernel; then
        # Lists that are missing or too old.
        as_root=()
        if ((EUID != 0)); then as_root=(sudo -n); fi
        if ! "${as_root[@]}" apt-get -qq -o DPkg::Lock::Timeout=300 update || ! download_kernel; then is_here=false; fi
    fi
    if $is_here; then
        rm -rf "$cache/kernel"
        package=$(kernel_package)
        dpkg-deb -x "$cache/$package"_*.deb "$cache/kernel"
        rm -f "$cache"/*.deb
        printf '%s\n' "$package" >"$cache/kernel/complete"
    elif [[ -z $unpacked ]]; then
        fail "linux-image-rt-amd64 cannot be downloaded"
    fi
fi

modules=$(echo "$cache"/kernel/lib/modules/*/kernel/drivers)
root=$output/root
rm -rf "$root"
mkdir -p "$root"/{bin,dev,proc,sys,tmp}
cp "$cache"/kernel/boot/vmlinuz-* "$output/vmlinuz"
cp "$(command -v busybox)" "$root/bin/busybox"
ln -s busybox "$root/bin/sh"
cp "$modules/parport/parport.ko" "$modules/parport/parport_pc.ko" "$modules/char/ppdev.ko" "$root/"
flock -u 9
cp "$init" "$root/init"
chmod +x "$root/init"
while (($#)) && [[ $1 != -- ]]; do
    cp "$1" "$root/"
    shift
done
shift
for program in "$@"; do
    program=$(command -v "$program") || fail "a program of the guest is not here; scripts/deps.sh test, or PSICARVE_SKIP_HARDWARE=1"
    cp "$program" "$root/bin/"
    ldd "$program" | grep -o '/[^ ]*' | sort -u | while read -r library; do
        mkdir -p "$root$(dirname "$library")"
        cp -L -n "$library" "$root$library"
    done
done
(cd "$root" && find . | cpio --quiet -o -H newc) >"$output/initramfs"
