#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/gpu-check with this program, from which all devices are hidden, and with programs that only pretend to have one:
# gpu_check_test.sh PROGRAM.
set -euo pipefail
program=$(realpath "$1")
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $1"; cat log; exit 1; }

# A copy, because --docs changes a page.
mkdir scripts cmake docs fake
cp "$source/scripts/gpu-check" scripts
cp "$source/cmake/json_rows.cmake" cmake
cp "$source/docs/cuda.md" docs

check() {  # STATUS ARGUMENTS…
  local expected=$1 status=0
  shift
  scripts/gpu-check "$@" > log 2>&1 || status=$?
  ((status == expected)) || fail "status $status, expected $expected: gpu-check $*"
}
rows() { cmake -DJSON=out/gpu-check/gpu-check.json "$@" -P cmake/json_rows.cmake; }
expect() { [[ $2 == "$3" ]] || fail "$1: found $2, expected $3"; }
statuses() { rows -DLIST=parts -DKEYS=name,status | sed -n "s/\t$1\$//p" | paste -sd ' '; }
names="doctor cuda-tests picture-tests memcheck racecheck state-hashes bench scaling frames"

# Without a device.
CUDA_VISIBLE_DEVICES="" check 0 --build "$(dirname "$program")" --docs
expect "parts skipped" "$(statuses skipped)" "$names"
expect "status" "$(rows -DKEYS=status,device)" $'skipped\t-'
reason=$(rows -DLIST=parts -DKEYS=reason | sort -u)
[[ $reason == "no CUDA device: "?* ]] || fail "reason: $reason"
cmp docs/cuda.md "$source/docs/cuda.md" || fail "docs/cuda.md was changed"
grep -q '^| frames |.*| skipped |.*no CUDA device' out/gpu-check/cuda-tables.md || fail "cuda-tables.md"

# With programs that pretend.
cat > fake/ballpit << 'FAKE'
#!/usr/bin/env bash
case "$*" in
  doctor*) echo '{"cuda": {"available": true, "device": "Pretended GPU", "reason": ""},
                  "gl": {"renderer": "pretended", "software": false}}' ;;
  list*) echo '{"scenes": [{"name": "balls"}, {"name": "events"}]}' ;;
  *events*cuda*) echo "ballpit: --backend: found cuda, allowed cpu" >&2; exit 2 ;;
  simulate*) echo '{"state_hash": "'"${FAKE_HASH:-0123456789abcdef}"'"}' ;;
  bench*) echo '{"entries": [{"count": '"$3"', "method": "sorted-grid", "backend": "cpu", "seconds": 0.006},
                             {"count": '"$3"', "method": "sorted-grid", "backend": "cuda", "seconds": 0.0002}]}' ;;
  lab*) mkdir -p "$5/scaling"; printf 'sorted-grid,cuda,0,1000,0.25,0.2,0.3,7\n' > "$5/scaling/times.csv" ;;
  render*)
    [[ $(< "$2") =~ count\ =\ ([0-9]+) ]] && count=${BASH_REMATCH[1]}
    [[ $* =~ --size\ ([^ ]+) ]] && size=${BASH_REMATCH[1]}
    bodies=${FAKE_BODIES:-written by cuda} fps=40
    [[ $* != *--copy-bodies* ]] || { bodies=copied fps=20; }
    echo '{"count": '"$count"', "size": "'"$size"'", "bodies": "'"$bodies"'", "frames_per_second": '"$fps"'}' ;;
  *) exit 1 ;;
esac
FAKE
cat > fake/test_cuda << 'FAKE'
#!/usr/bin/env bash
[[ -z ${FAKE_FAILURE:-} || $# -gt 0 ]] || { echo 'test cases: 2 | 1 passed | 1 "failed"'; exit 1; }
echo "All tests passed (5 assertions in 2 test cases)"
FAKE
cat > fake/compute-sanitizer << 'FAKE'
#!/usr/bin/env bash
shift 4
exec "$@"
FAKE
cp fake/test_cuda fake/test_render
chmod +x fake/*
export PATH=$folder/fake:$PATH

check 0 --build fake --docs
expect "parts passed" "$(statuses passed)" "$names"
expect "status" "$(rows -DKEYS=status,device)" $'passed\tPretended GPU'
expect "parts without figures" "$(rows -DLIST=parts -DKEYS=figures,name | sed -n 's/^-\t//p')" ""
for line in '^\*\*Pretended GPU\*\*' '^| 10 000 000 | 6 | 0.2 | 30 |$' '^| 1 000 | 0.25 |$' '^| 10 000 | 40 | 20 | 40 | 20 |$' \
            '^| state-hashes |.*| equal scenes: 1; not for CUDA: events |$'; do
  grep -q "$line" out/gpu-check/cuda-tables.md || fail "cuda-tables.md lacks $line"
  grep -q "$line" docs/cuda.md || fail "docs/cuda.md lacks $line"
done
! grep -q 'NVIDIA H100' <(sed -n '/gpu-check: begin/,/gpu-check: end/p' docs/cuda.md) || fail "docs/cuda.md keeps older tables"
diff <(sed '/gpu-check: begin/,/gpu-check: end/d' docs/cuda.md) <(sed '/gpu-check: begin/,/gpu-check: end/d' "$source/docs/cuda.md") ||
  fail "docs/cuda.md changed outside its tables"

# With failures.
FAKE_FAILURE=1 FAKE_BODIES="copied: another device" FAKE_HASH=none check 1 --build fake
expect "parts failed" "$(statuses failed)" "cuda-tests picture-tests state-hashes frames"
expect "parts passed" "$(statuses passed)" "doctor memcheck racecheck bench scaling"
for reason in 'test_cuda: status 1: test cases: 2 | 1 passed | 1 "failed"' 'other bits on CUDA than on the CPU: balls' \
              'interop: bodies copied: another device'; do
  grep -qF "$reason" <(rows -DLIST=parts -DKEYS=reason) || fail "reason missing: $reason"
done
grep -qF '| test_cuda: status 1: test cases: 2 \| 1 passed \| 1 "failed" |' out/gpu-check/cuda-tables.md || fail "cuda-tables.md"

# Wrong arguments.
for wrong in "--parts walk" "--parts" "--speed" "--docs --parts doctor"; do
  # shellcheck disable=SC2086
  check 2 $wrong
  grep -q '^scripts/gpu-check: .*found .*, allowed ' log || fail "message"
  expect "lines" "$(wc -l < log)" 1
done
