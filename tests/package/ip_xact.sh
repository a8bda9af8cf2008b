#!/usr/bin/env bash
# The cores as IP-XACT components, rtl/host/steplock.xml and steplock_sinusoidal.xml.
#   ip_xact.sh current            they are what tools/ip_xact prints
#   ip_xact.sh whole FILE TOP     valid by ip_xact.xsd; its ports and widths are those that Yosys reads from rtl/TOP.sv; every reference and file is there;
#                                 the bus has every signal of AXI4-Lite but ARESETn
#   ip_xact.sh flaws WORK         `whole` refuses each of some broken ones
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..

# texts FILE A B ...: of every element B within A, sorted.
texts() {
  local file=$1 path= name
  for name in "${@:2}"; do path+="/*[local-name()='$name']"; done
  xmllint --xpath "/$path/text()" "$file" 2>/dev/null | sort
}
broken() { echo "$1: $2"; exit 1; }
# each WHAT OF_THESE IN_THOSE
each() {
  local missing
  missing=$(comm -23 <(sort -u <<<"$2") <(sort -u <<<"$3"))
  [ -z "$missing" ] || broken "$file" "$1: $(tr '\n' ' ' <<<"$missing")"
}

whole() {
  file=$1
  local top=$2 said ports declared name
  if ! said=$(xmllint --noout --schema "$here/ip_xact.xsd" "$file" 2>&1); then broken "$file" "$said"; fi
  ports=$(xmllint --format "$file" | awk -F '[<>]' '
    /<ipxact:port>/ { within = 1; name = direction = left = "" }
    within && /<ipxact:name>/ && name == "" { name = $3 }
    within && /<ipxact:direction>/ { direction = $3 }
    within && /<ipxact:left>/ && left == "" { left = $3 }
    /<\/ipxact:port>/ { print direction, name, left + 1; within = 0 }')
  declared=$(yosys -q -p "read_verilog -sv $root/rtl/$top.sv; write_json /dev/stdout" | jq -r --arg top "$top" \
    '.modules[$top].ports | to_entries[] | "\(.value.direction | sub("put"; "")) \(.key) \(.value.bits | length)"')
  each "ports that the module does not have" "$ports" "$declared"
  each "ports that are left out" "$declared" "$ports"
  each "physical ports that are none" "$(texts "$file" physicalPort name)" "$(texts "$file" port name)"
  each "signals of AXI4-Lite without a port" "$(printf '%s\n' ACLK AWVALID AWREADY AWADDR WVALID WREADY WDATA WSTRB BVALID BREADY BRESP ARVALID \
    ARREADY ARADDR RVALID RREADY RDATA RRESP)" "$(texts "$file" logicalPort name)"
  each "memory maps that are none" "$(xmllint --xpath 'string(//@memoryMapRef)' "$file")" "$(texts "$file" memoryMap name)"
  each "views that are none" "$(texts "$file" viewRef)" "$(texts "$file" view name)"
  each "instantiations that are none" "$(texts "$file" componentInstantiationRef)" "$(texts "$file" componentInstantiation name)"
  each "file sets that are none" "$(texts "$file" fileSetRef localName)" "$(texts "$file" fileSet name)"
  each "values that are no parameters" "$(texts "$file" moduleParameter value)" "$(texts "$file" parameter name)"
  each "parameters that the module does not have" "$(texts "$file" moduleParameter name)" \
    "$(sed -n 's/^ *parameter logic \([A-Z_]*\) .*/\1/p' "$root/rtl/$top.sv")"
  each "parameters that are left out" "$(sed -n 's/^ *parameter logic \([A-Z_]*\) .*/\1/p' "$root/rtl/$top.sv")" "$(texts "$file" moduleParameter name)"
  for name in $(texts "$file" file name); do
    [ -e "$root/rtl/host/$name" ] || broken "$file" "no file $name"
  done
  each "files of rtl/$top.f that are left out" "$(sed 's|^rtl/|../|' "$root/rtl/$top.f")" "$(texts "$file" file name)"
  echo "$file is whole: $(wc -l <<<"$ports") ports"
}

case $1 in
  current)
    cd "$root"
    tools/ip_xact | diff - rtl/host/steplock.xml
    tools/ip_xact --sinusoidal | diff - rtl/host/steplock_sinusoidal.xml ;;
  whole) whole "$2" "$3" ;;
  flaws)
    mkdir -p "$2"
    failed=0
    flaw() {  # flaw WHAT SED SAYS
      local said
      sed "$2" "$root/rtl/host/steplock.xml" >"$work/flawed.xml"
      ! cmp -s "$work/flawed.xml" "$root/rtl/host/steplock.xml" || { echo "$1: nothing is changed"; failed=1; }
      if said=$(whole "$work/flawed.xml" six_step_axi 2>&1) || [[ $said != *"$3"* ]]; then echo "$1: said $said"; failed=1; fi
    }
    work=$2
    flaw "order"           '/<ipxact:busType/{h;d}; /<ipxact:slave>/{x;G}'                  'is not expected'
    flaw "no name"         '0,/<ipxact:name>axi</s/<ipxact:name>axi<.*//'                   'is not expected'
    flaw "direction"       '0,/<ipxact:direction>in</s//<ipxact:direction>input</'          'not an element of the set'
    flaw "other direction" '/<ipxact:name>gates_uh_o</,/wire/s/direction>out/direction>in/' 'ports that the module does not have'
    flaw "width"           's/<ipxact:left>11</<ipxact:left>10</'                           'ports that the module does not have'
    flaw "a port less"     '/<ipxact:port>/{:a;N;/<\/ipxact:port>/!ba;/locked_o/d}'         'ports that are left out: out locked_o 1'
    flaw "mapped to none"  's/<ipxact:name>axi_wdata_i<\/ipxact:name><\/ipxact:physicalPort>/<ipxact:name>wdata<\/ipxact:name><\/ipxact:physicalPort>/' 'physical ports that are none: wdata'
    flaw "bus signal"      's/<ipxact:name>WSTRB</<ipxact:name>WSTROBE</'                   'signals of AXI4-Lite without a port: WSTRB'
    flaw "memory map"      's/memoryMapRef="registers"/memoryMapRef="words"/'               'memory maps that are none: words'
    flaw "a file's name"   's|\.\./protection.sv|../protections.sv|'                        'no file ../protections.sv'
    flaw "a file less"     '/\.\.\/protection.sv/d'                                         'that are left out: ../protection.sv'
    flaw "parameter"       's/<ipxact:value>WITH_RAMP</<ipxact:value>WITHOUT_RAMP</'        'values that are no parameters: WITHOUT_RAMP'
    [ $failed = 0 ] && echo 'each is refused' ;;
esac
