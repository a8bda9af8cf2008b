#!/usr/bin/env bash
# Proves by SAT that the map of tools/prove_print makes a product: every shape of it against Yosys's own
# product, cut short and extended, of both signs.
#
#     rows_of_adders.sh MAP
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for sign in unsigned signed; do
  for shape in "1 1 2" "1 3 4" "4 3 7" "4 4 4" "5 2 12" "6 6 12"; do
    read -r a b y <<< "$shape"
    cat > "$work/product.sv" <<END
module product (input $sign [$((a - 1)):0] a, input $sign [$((b - 1)):0] b, output $sign [$((y - 1)):0] y);
  assign y = a * b;
endmodule
END
    yosys -Q -q -p "read_verilog -sv $work/product.sv; proc; copy product mapped
      cd mapped; select -assert-count 1 t:\$mul; techmap -map $1; select -assert-none t:\$mul; cd ..
      miter -equiv -make_assert -flatten product mapped miter
      sat -verify -prove-asserts miter" > "$work/log" 2>&1 || {
      echo "no product: $sign, $a bits by $b bits to $y bits"
      tail -5 "$work/log"
      exit 1
    }
  done
done
echo "all products are products"
