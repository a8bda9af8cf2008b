// hall_decoder: steplock::HallDecoder, printed by hlsgen from hls/six_step/hall_decoder.hpp:27.
// Do not edit: change the C++ and print again.

module hall_decoder (
    input  logic       clk,
    input  logic       rst,  // synchronous, active high
    input  logic       u_i,  // synchronised
    input  logic       v_i,  // synchronised
    input  logic       w_i,  // synchronised
    input  logic [9:0] hold_i,  // clocks
    output logic [2:0] sector_o,  // 0 to 5: of the last legal code
    output logic       legal_o,  // the code that stands is legal
    output logic       moved_o,  // one clock: the sector is new, and the rotor went on to it
    output logic       reverse_o,  // the last move went down
    output logic       jumped_o  // one clock: the sector is new, and says nothing about speed
);
  logic [2:0] code;  // u v w, one clock ago
  logic [9:0] left;  // clocks until the code counts
  logic stood;  // none: it counts
  logic [2:0] sector;  // 0 to 5: of the last legal code
  logic legal;  // of the last code that counted
  logic moved;  // one clock: to a neighbour, in earnest
  logic reverse;  // the last move went down
  logic sure;  // there was a move since the last jump
  logic back;  // the sector is the one before the last move's
  logic jumped;  // one clock: to no neighbour

  wire [2:0] code_next = (u_i ? 3'd4 : 3'd0) | {1'b0, v_i ? 2'd2 : 2'd0} | {2'd0, w_i};  // line 68

  always_ff @(posedge clk) begin
    code <= code_next;  // line 68
    if (code_next == code) begin
      if (!stood) begin
        left <= left - 10'd1;
      end
      stood <= stood || left == 10'd1;
    end else begin
      left <= hold_i;
      stood <= hold_i == 10'd0;
    end
    if (stood) begin
      logic [2:0] decoded_sector;  // line 50
      logic unequal;
      logic either;
      logic either_2;
      logic [2:0] choice_52;
      logic equal_52;
      logic [2:0] choice_53;
      logic equal_53;
      logic both_57;
      case (code)
        3'd4: decoded_sector = 3'd1;
        3'd6: decoded_sector = 3'd2;
        3'd2: decoded_sector = 3'd3;
        3'd3: decoded_sector = 3'd4;
        3'd1: decoded_sector = 3'd5;
        default: decoded_sector = 3'd0;
      endcase
      unequal = decoded_sector != sector;
      either = code == 3'd5 || code == 3'd4 || code == 3'd6;
      either_2 = either || code == 3'd2 || code == 3'd3 || code == 3'd1;
      choice_52 = (sector == 3'd5) ? 3'd0 : sector + 3'd1;  // line 52
      equal_52 = decoded_sector == choice_52;  // line 52
      choice_53 = (code == 3'd1) ? 3'd0 : decoded_sector + 3'd1;  // line 53
      equal_53 = sector == choice_53;  // line 53
      both_57 = sure && (equal_53 ^ reverse);  // line 57
      if (either_2) begin
        if (!legal || unequal) begin
          case (code)
            3'd1: sector <= 3'd5;
            3'd2: sector <= 3'd3;
            3'd3: sector <= 3'd4;
            3'd4: sector <= 3'd1;
            3'd5: sector <= 3'd0;
            default: sector <= 3'd2;
          endcase
        end
        if (legal) begin
          if (unequal) begin
            logic either_3;
            either_3 = equal_52 || equal_53;
            sure <= either_3;
            back <= either_3 && both_57 && !back;
            jumped <= !either_3;
          end else begin
            jumped <= 1'b0;
          end
        end else begin
          sure <= 1'b0;
          back <= 1'b0;
          jumped <= 1'b1;
        end
      end else begin
        jumped <= 1'b0;
      end
      legal <= either_2;
      if (legal) begin
        if (either_2) begin
          if (unequal) begin
            if (both_57 ^ back) begin
              moved <= 1'b0;
            end else if (equal_53) begin
              moved <= 1'b1;
              reverse <= 1'b1;
            end else begin
              moved <= equal_52;
              reverse <= !equal_52 && reverse;
            end
          end else begin
            moved <= 1'b0;
          end
        end else begin
          moved <= 1'b0;
        end
      end else begin
        moved <= 1'b0;
      end
    end else begin
      moved <= 1'b0;
      jumped <= 1'b0;
    end
    if (rst) begin
      code <= 3'd0;
      left <= 10'd0;
      stood <= 1'b1;
      sector <= 3'd0;
      legal <= 1'b0;
      moved <= 1'b0;
      reverse <= 1'b0;
      sure <= 1'b0;
      back <= 1'b0;
      jumped <= 1'b0;
    end
  end

  assign sector_o = sector;
  assign legal_o = legal;
  assign moved_o = moved;
  assign reverse_o = reverse;
  assign jumped_o = jumped;
endmodule
