#!/bin/sh
# The first process of the User-Mode Linux that uml_can_test.py starts. It sets up a CAN bus of the
# kernel with `kerfline serve` as a node, `kerfline send` as its host, and can-utils as listeners.
#
# The kernel's command line sets KERFLINE (program), PORT_TESTS (hal_tests), EXAMPLES, RESULTS (a
# folder of the host) and SPEED (speed of the job that runs to its end).
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t tmpfs tmp /run
cd "$RESULTS" || poweroff -f
modules=/usr/lib/uml/modules/$(uname -r)/kernel
for module in net/can/can net/can/can-raw drivers/net/can/dev/can-dev drivers/net/can/vcan; do
  insmod "$modules/$module.ko" || echo "$module" >>no_modules
done
ip link add dev vcan0 type vcan
# Buffers of 4 MB, so that a listener loses no frame if a busy machine lets it read late.
echo 4194304 >/proc/sys/net/core/rmem_max
echo 4194304 >/proc/sys/net/core/rmem_default
exec >guest.log 2>&1 </dev/null

# until_seen WORD FILES [TIMES]: waits at most a minute. An unfinished log is a hidden file.
writing='.kerfline-*.part'
until_seen() {
  tries=600
  # shellcheck disable=SC2086  # FILES may be a pattern.
  until [ "$(cat $2 2>/dev/null | grep -c -- "$1")" -ge "${3:-1}" ] || [ $tries -eq 0 ]; do
    sleep 0.1
    tries=$((tries - 1))
  done
}

# serve NAME ARGUMENTS…: candump and isotpdump listen before the server sends its first frame.
serve() {
  name=$1
  shift
  candump -ta vcan0 >"$name.candump" &
  candump=$!
  isotpdump -s 511 -d 491 -ta vcan0 >"$name.isotp" &
  isotpdump=$!
  "$KERFLINE" serve --can vcan0 --node 17 --settings "$EXAMPLES/laser.settings" \
    --trace "$name.trace" --record "$name.record" "$@" >"$name.served" 2>&1 &
  served=$!
  until_seen ready "$name.served"
}
end_serving() {
  kill $served
  wait $served
  echo $? >"$name.status"
  sleep 2  # Time for their last writes.
  kill $candump $isotpdump
}
# send NAME JOB
send() {
  "$KERFLINE" send "$EXAMPLES/$2" --can vcan0 --node 17 --log "$1.sent" >"$1.out" 2>"$1.err"
  echo $? >"$1.exit"
}

for name in nosuch0 lo vcan0; do  # vcan0 is down.
  "$KERFLINE" serve --can $name >>refused 2>&1
  echo $? >>refused
done
ip link set lo up
ip link set vcan0 up
"$KERFLINE" send "$EXAMPLES/circle_r20.nc" --can vcan0 --node 17 >/dev/null 2>>refused
echo $? >>refused
KERFLINE_CAN=vcan0 "$PORT_TESTS" --gtest_filter='SocketCan*' >port_tests 2>&1
echo $? >port_tests.exit
touch booted

serve job --speed "$SPEED"
send job sheet_8877.nc
end_serving

# Another node sends an emergency stop of the network while the machine cuts.
serve stop --speed 2
send stop sheet_8877.nc &
sender=$!
until_seen '<Run' "$writing" 8
cansend vcan0 000#0200
wait $sender
end_serving

# First a sender is killed, then the bus goes down during another one; each time a new sender
# follows. A loss is detected after 50 ms of silence. On a busy machine this takes longer: 2 s.
serve lost --speed 2
"$KERFLINE" send "$EXAMPLES/sheet_8877.nc" --can vcan0 --log killed.sent >/dev/null 2>&1 &
sender=$!
until_seen '<Run' "$writing" 5
kill -9 $sender
rm -f .kerfline-$sender-*.part
until_seen ' 091 .* 30 81 ' lost.candump
send down sheet_8877.nc &
sender=$!
until_seen '<Run' "$writing" 5
ip link set vcan0 down
wait $sender
sleep 2
ip link set vcan0 up
send again circle_r20.nc
sleep 2
end_serving

touch done
poweroff -f
