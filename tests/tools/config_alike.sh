#!/usr/bin/env bash
# The words of each drive as its user takes them: the C header compiles, the list read by $readmemh says the same, and the
# constants fit the drive around which they stand.
#   config_alike.sh FOLDER WORK      FOLDER as rtl/config
set -euo pipefail
words=$(realpath "$1") work=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$work"
cd "$work"
bad=0
for header in "$words"/*.h; do
  name=$(basename "$header" .h)
  cat >list.c <<PROGRAM
#include <stdio.h>
#include "$header"
int main(void) {
  for (size_t i = 0; i < sizeof ${name}_config / sizeof ${name}_config[0]; ++i)
    if (${name}_config[i].offset != STEPLOCK_CLOCK)  /* compared with the drive's, not written: none of the list */
      printf("%08x%08x\\n", (unsigned)${name}_config[i].offset, (unsigned)${name}_config[i].value);
  return 0;
}
PROGRAM
  cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I "$root/rtl/host" list.c -o list
  ./list >of_c
  cat >list.sv <<MODULE
module list;
  logic [63:0] words[0:$(($(wc -l <of_c) - 1))];
  initial begin
    \$readmemh("$words/$name.mem", words);
    foreach (words[i]) \$display("%h", words[i]);
  end
endmodule
MODULE
  iverilog -g2012 -o list.vvp list.sv
  vvp -n list.vvp >of_list
  cmp -s of_c of_list || { echo "$name: C header and list differ:"; diff of_c of_list || true; bad=1; }
  top=$(sed -n 's/^module \([a-z_]*\)_fixed .*/\1/p' "$words/$name.sv")
  (cd "$root" && verilator --lint-only -Wall -Wno-UNUSED -Wno-DECLFILENAME --top-module "${top}_fixed" -f "rtl/${top}_standalone.f" "$words/$name.sv") ||
    { echo "$name: the constants are not clean"; bad=1; }
done
exit $bad
