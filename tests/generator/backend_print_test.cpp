// What the readable printer writes, on small netlists made by hand.

#include "generator/backend.hpp"
#include "generator/print/write_expression.hpp"
#include "tests/generator/build.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace hlsgen {
namespace {

using test::Build;

Design design_of(Build b) {
  Design d;
  d.modules.push_back(std::move(b.m));
  check(d);
  return d;
}
std::string printed(Build b) {
  const Design d = design_of(std::move(b));
  return print_module(d, d.modules.back());
}
#define EXPECT_PRINTS(text, line) \
  EXPECT_NE((text).find(line), std::string::npos) << "no `" << (line) << "` in\n" << (text)

Build counter() {
  Build b("counter");
  const NodeId load = b.input("load", 1), enable = b.input("enable", 1), start = b.input("start", 8);
  const NodeId count = b.reg("count", 8, 3);
  const NodeId sum = b.op(Op::kAdd, count, b.constant(8, 255));
  b.next(count, b.mux(load, start, b.mux(enable, sum, count)));
  b.output("count", count);
  return b;
}

TEST(Print, UpdatesOfARegisterReadAsIfs) {
  const std::string text = printed(counter());
  EXPECT_PRINTS(text,
                "    if (load_i) begin\n"
                "      count <= start_i;\n"
                "    end else if (enable_i) begin\n"
                "      count <= count - 8'd1;\n"
                "    end\n"
                "    if (rst) begin\n"
                "      count <= 8'd3;\n"
                "    end\n");
}

TEST(Print, HeaderSaysWhereItCameFrom) {
  EXPECT_EQ(printed(counter()).rfind("// counter: test::Block, printed by hlsgen from "
                                     "hls/test/block.hpp:10.\n// Do not edit",
                                     0),
            0u);
}

TEST(Print, NextValueThatIsReadTwiceIsNamedAfterItsRegister) {
  Build b("twice");
  const NodeId r = b.reg("phase", 4);
  const NodeId sum = b.op(Op::kAdd, r, b.input("step", 4));
  b.next(r, sum);
  b.output("phase", sum);
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "wire [3:0] phase_next = phase + step_i;");
  EXPECT_PRINTS(text, "phase <= phase_next;");
  EXPECT_PRINTS(text, "assign phase_o = phase_next;");
}

TEST(Print, ChainOfEqualitiesIsACaseAndTwoOfThemAreOne) {
  Build b("chain");
  b.m.enumerations.push_back({"State", 2, {{"kIdle", 0}, {"kRun", 1}, {"kStop", 2}}});
  const NodeId s = b.input("state", 2, false, 0), x = b.input("x", 4), y = b.input("y", 4);
  const auto is = [&](unsigned v) { return b.op(Op::kEq, s, b.constant(2, v)); };
  const auto chain = [&](NodeId p, NodeId q, NodeId r, NodeId otherwise) {
    const NodeId third = b.mux(is(2), r, otherwise);
    const NodeId second = b.mux(is(1), q, third);
    return b.mux(is(0), p, second);
  };
  const NodeId zero = b.constant(4, 0);
  b.output("a", b.named(chain(x, y, zero, zero), "first"));
  b.output("b", b.named(chain(y, x, y, zero), "second"));
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "localparam logic [1:0] State_kRun = 2'd1;");
  EXPECT_PRINTS(text,
                "    case (state_i)\n"
                "      State_kIdle: begin\n"
                "        first = x_i;\n"
                "        second = y_i;\n"
                "      end\n");
  EXPECT_EQ(text.find("always_comb"), text.rfind("always_comb"));
}

TEST(Print, ProductIsAsNarrowAsItsFactors) {
  Build b("product");
  const NodeId x = b.input("x", 16, true), k = b.input("k", 10);
  b.output("p", b.op(Op::kMul, b.sext(x, 27), b.zext(k, 27)));
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "wire [26:0] p = $signed(x_i) * $signed({1'b0, k_i});");
}

TEST(Print, ProductThatIsCutIsStillNarrow) {
  Build b("cut");
  const NodeId x = b.input("x", 8), k = b.input("k", 6);
  b.output("p", b.op(Op::kMul, b.zext(x, 12), b.zext(k, 12)));
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "wire [13:0] p_full = x_i * k_i;");
  EXPECT_PRINTS(text, "wire [11:0] p = p_full[11:0];");
  EXPECT_PRINTS(text, "wire unused = &{1'b0, p_full[13:12]};");
}

TEST(Print, SignedOperatorsStandWhereNothingUnsignedReachesThem) {
  Build b("shift");
  const NodeId x = b.input("x", 8, true), n = b.input("n", 3), y = b.input("y", 8);
  b.output("z", b.op(Op::kAdd, b.op(Op::kAshr, x, n), y));
  b.output("l", b.op(Op::kSlt, x, b.constant(8, 0xfd)));
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "wire [7:0] shifted = $signed(x_i) >>> n_i;");
  EXPECT_PRINTS(text, "assign z_o = shifted + y_i;");
  EXPECT_PRINTS(text, "assign l_o = $signed(x_i) < -8'sd3;");
}

TEST(Print, NamesAvoidKeywordsAndEachOtherWithoutRegardToCase) {
  Build b("names");
  const NodeId r = b.reg("reg", 1), s = b.reg("Reg_", 1), t = b.reg("rst", 1);
  b.next(r, s);
  b.next(s, t);
  b.next(t, r);
  b.output("table", r);
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "logic reg_;");
  EXPECT_PRINTS(text, "logic rst_2;");
  EXPECT_PRINTS(text, "reg_ <= Reg__2;");
}

TEST(Print, CommentThatAToolWouldObeyIsDisarmed) {
  EXPECT_EQ(write_comment("verilator lint_off WIDTH"), "  // C++: verilator lint_off WIDTH");
  EXPECT_EQ(write_comment("a\nb"), "  // a b");
}

TEST(Print, LongExpressionsStayWithinTheColumns) {
  Build b("wide");
  std::vector<NodeId> parts;
  for (int i = 0; i < 20; ++i) parts.push_back(b.input("a_rather_long_name" + std::to_string(i), 3));
  b.output("all", b.concat(parts));
  NodeId choice = parts[0];
  for (int i = 1; i < 6; ++i)
    choice = b.mux(b.op(Op::kUlt, parts[i], parts[i + 1]), parts[i + 7], choice);
  b.output("choice", choice);
  const std::string text = printed(std::move(b));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), kColumns) << line;
}

TEST(Print, InstanceIsConnectedByName) {
  Design d = design_of(counter());
  Build b("parent");
  const NodeId go = b.input("go", 1);
  const NodeId one = b.constant(8, 1);
  b.m.instances.push_back({"ticks", "counter", {go, go, one}});
  b.output("n", b.instance_output(0, 0, 8));
  d.modules.push_back(std::move(b.m));
  check(d);
  const std::string text = print_module(d, d.modules[1]);
  EXPECT_PRINTS(text, "  wire [7:0] ticks_count;\n  counter ticks (\n      .clk(clk),\n");
  EXPECT_PRINTS(text, ".start_i(8'd1),\n      .count_o(ticks_count)\n");
  EXPECT_EQ(print_file_list(d), "rtl/counter.sv\nrtl/parent.sv\n");
}

TEST(Check, RefusesAnOperandBehindItsUser) {
  Build b("loop");
  const NodeId x = b.input("x", 1);
  b.output("y", b.inv(x));
  b.m.nodes[1].in[0] = 1;
  Design d;
  d.modules.push_back(std::move(b.m));
  EXPECT_THROW(check(d), NetlistError);
}

TEST(Check, RefusesWidthsThatDoNotFit) {
  Build b("widths");
  b.output("y", b.op(Op::kAdd, b.input("x", 4), b.constant(5, 1)));
  Design d;
  d.modules.push_back(std::move(b.m));
  EXPECT_THROW(check(d), NetlistError);
}

TEST(Check, RefusesTwoPortsOfOneName) {
  Build b("ports");
  const NodeId x = b.input("a.b", 4);
  b.input("A_b", 4);
  b.output("y", x);
  Design d;
  d.modules.push_back(std::move(b.m));
  EXPECT_THROW(check(d), NetlistError);
}

}  // namespace
}  // namespace hlsgen
