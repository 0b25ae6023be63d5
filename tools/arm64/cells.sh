# Tries cells on a kernel for ARM: QEMU's full emulation of a machine, Debian's kernel, and in its memory nothing but the tests of
# src/mlab/cell. Sourced by tools/agent_arm64, behind make.sh.

machine=/root/machine

# Debian's kernel and a shell; the libraries that the tests load.
install_cell_tests() {
  local kernel
  inside "$compilers" apt-get -y -q --no-install-recommends install qemu-system-arm cpio libgtest-dev:arm64 librapidcheck-dev:arm64
  inside "$compilers" apt-get clean
  kernel=$(inside "$compilers" apt-cache depends linux-image-arm64:arm64 | awk '$1 == "Depends:" { print $2; exit }')
  mkdir -p "$compilers$machine/packages"
  inside "$compilers" sh -c 'cd "$0/packages" && apt-get -q download "$@"' "$machine" busybox-static:arm64 "${kernel%:arm64}:arm64"
  rm -rf "$compilers$machine/parts"
  inside "$compilers" sh -c 'cd "$0" && for each in packages/*.deb; do dpkg -x "$each" parts; done' "$machine"
  cp "$(command -v qemu-aarch64-static)" "$compilers/usr/bin/"
}

# The build asks each test program for its tests, which QEMU's user mode answers.
build_cell_tests() {
  compile cmake -S /source -B /compiled/tests -G Ninja --toolchain /source/cmake/aarch64-linux-gnu.cmake -DCMAKE_BUILD_TYPE=Release \
    -DMLAB_UNITY=ON -DMLAB_TESTS=ON -DMLAB_WEB=OFF -DMLAB_CNLC=/native/cnlc -DCMAKE_CROSSCOMPILING_EMULATOR=/usr/bin/qemu-aarch64-static
  compile ninja -C /compiled/tests -j "$(job_count)" mlab_cell_test cell_attack
}

# A disk in memory: a shell, the tests at the place that they were built for, their libraries.
pack_machine() {
  local disk=$compilers$machine/disk name
  rm -rf "$disk"
  mkdir -p "$disk"/{bin,dev,etc,home,proc,root,sys,tmp} "$disk/compiled/tests/bin" "$disk/usr/bin" "$disk/usr/lib/aarch64-linux-gnu"
  ln -s usr/lib "$disk/lib"
  cp "$compilers$machine/parts/bin/busybox" "$disk/bin/"
  ln -s /bin/busybox "$disk/usr/bin/true"
  cp "$folder"/compiled/tests/bin/{mlab_cell_test,cell_attack} "$disk/compiled/tests/bin/"
  cp -L "$compilers/lib/ld-linux-aarch64.so.1" "$disk/usr/lib/"
  for name in libc.so.6 libm.so.6 libstdc++.so.6 libgcc_s.so.1 libfmt.so.9 libseccomp.so.2; do
    cp -L "$compilers/usr/lib/aarch64-linux-gnu/$name" "$disk/usr/lib/aarch64-linux-gnu/"
  done
  echo "root:x:0:0::/root:/bin/sh" >"$disk/etc/passwd"
  cat >"$disk/init" <<'END'
#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin:/usr/bin HOME=/root
mount -t proc proc /proc && mount -t sysfs sys /sys && mount -t devtmpfs dev /dev
mkdir -p /dev/shm && mount -t tmpfs shm /dev/shm && mount -t tmpfs tmp /tmp && chmod 1777 /tmp
ip link set lo up
uname -srvm
/compiled/tests/bin/mlab_cell_test --gtest_color=no && echo "the cells hold"
poweroff -f
END
  chmod 755 "$disk/init"
  inside "$compilers" sh -c 'cd "$0/disk" && find . | cpio -o -H newc --quiet | gzip -1 >../disk.gz' "$machine"
}

run_machine() {
  inside "$compilers" sh -c 'exec nice -n 10 timeout 1200 qemu-system-aarch64 -M virt -cpu cortex-a72 -m 2048 -smp 2 -nodefaults -display none \
    -serial stdio -no-reboot -kernel "$0"/parts/boot/vmlinuz-* -initrd "$0/disk.gz" -append "console=ttyAMA0 quiet panic=-1"' "$machine"
}

try_cells() {
  step "a kernel and what its tests take" install_cell_tests
  step "building the tests of cells" build_cell_tests
  step "packing a machine" pack_machine
  step "the tests of cells" run_machine
  grep -q "the cells hold" "$folder/the_tests_of_cells.log" || fail "a test of cells failed" "$(grep -E "Failure|FAILED" "$folder/the_tests_of_cells.log" | head -n 20)" \
    "all of it is in $folder/the_tests_of_cells.log"
  say "$(grep -oE "Linux .* aarch64" "$folder/the_tests_of_cells.log"): $(grep -E "^\[  PASSED" "$folder/the_tests_of_cells.log" | tr -d '\r' | sed 's/.*] //; s/\.$//') of cells passed"
}
