// A star-connected motor with sinusoidal back-EMF, on an inverter with diodes, in real numbers; every step_clocks one step of Euler.
//
//     e_k   = flux we sin(theta - 2 pi k / 3)              back-EMF, we in electrical rad/s
//     L i'  = v - v_n - R i - e                            of a phase that conducts: a gate is on, or its diode carries i
//     v_n   = mean of (v - e) over those                   their currents add up to 0
//     J w'  = P flux sum(i sin) - load - viscous w - coulomb sign(w)
//
// comparator_k: terminal k above the mean of all three; limit: the shunt, which carries what the high legs take from the
// bus, above limit_a.
//
// Doc: docs/integration.md   Test: tests/rtl/turning_motor.sh

`timescale 1ns / 1ps

module motor #(
    parameter real clock_hz = 24.0e6,
    parameter int step_clocks = 4,  // 1 where a voltage counts that lasts a clock, as of a slow rotor with sinusoidal currents
    parameter real resistance_ohm = 0.471,  // of a phase
    parameter real inductance_h = 0.1815e-3,  // of a phase, less what couples it with the others
    parameter real flux_vs = 2.72e-3,  // peak, per electrical rad/s
    parameter int pole_pairs = 8,
    parameter real inertia_kgm2 = 1.35e-5,
    parameter real coulomb_nm = 4.3e-3,
    parameter real viscous_nms = 6.8e-6,
    parameter real bus_v = 24.0,
    parameter real on_resistance_ohm = 0.01,  // of a switch
    parameter real diode_v = 0.8,
    parameter real limit_a = 7.0
) (
    input  logic       clk,
    input  logic [2:0] high,  // gates U, V, W
    input  logic [2:0] low,
    output logic [2:0] comparator = 3'b000,
    output logic       limit = 1'b0
);
  localparam real kPi = 3.14159265358979;

  real load_nm = 0.0;  // what a bench sets while it runs
  real pace = 1.0;  // likewise: of time; 2 with a clock of half the rate
  real theta = 0.0, speed = 0.0;  // electrical rad; mechanical rad/s
  real rpm = 0.0;  // mechanical
  real peak_a = 0.0;  // the highest current of a phase so far
  real i[3], e[3], v[3], s[3];
  logic conducts[3];
  real dt, v_n, torque, shunt, mean, drag, lowest;
  int clocks = 0, many;
  initial begin
    for (int k = 0; k < 3; k++) begin
      i[k] = 0.0;
      e[k] = 0.0;
      v[k] = 0.0;
      s[k] = 0.0;
    end
  end

  // Where a leg stands that neither switch nor diode holds: a diode begins to conduct when its terminal leaves the rails.
  task automatic legs;
    for (int k = 0; k < 3; k++) begin
      conducts[k] = 1'b1;
      if (high[k]) v[k] = bus_v - on_resistance_ohm * i[k];
      else if (low[k]) v[k] = -on_resistance_ohm * i[k];
      else if (i[k] > 0.0) v[k] = -diode_v;
      else if (i[k] < 0.0) v[k] = bus_v + diode_v;
      else conducts[k] = 1'b0;
    end
  endtask

  task automatic star;
    many = 0;
    v_n = 0.0;
    for (int k = 0; k < 3; k++) begin
      if (conducts[k]) begin
        many = many + 1;
        v_n = v_n + v[k] - e[k];
      end
    end
    if (many > 0) v_n = v_n / many;
    else begin  // the dividers of the comparators hold its mean at ground, the diodes its lowest terminal
      lowest = e[0] < e[1] ? (e[0] < e[2] ? e[0] : e[2]) : (e[1] < e[2] ? e[1] : e[2]);
      v_n = -diode_v - lowest > 0.0 ? -diode_v - lowest : 0.0;
    end
  endtask

  task automatic step;
    for (int k = 0; k < 3; k++) begin
      s[k] = $sin(theta - 2.0 * kPi * k / 3.0);
      e[k] = flux_vs * pole_pairs * speed * s[k];
    end
    legs;
    star;
    for (int k = 0; k < 3; k++) begin
      if (!conducts[k]) begin
        v[k] = v_n + e[k];
        if (v[k] > bus_v + diode_v || v[k] < -diode_v) begin
          v[k] = v[k] < 0.0 ? -diode_v : bus_v + diode_v;
          conducts[k] = 1'b1;
        end
      end
    end
    star;
    // A current that a diode carries ends at zero; what is left of it, the other two share.
    for (int k = 0; k < 3; k++) begin
      if (conducts[k] && many > 1) begin
        mean = i[k] + (v[k] - v_n - resistance_ohm * i[k] - e[k]) * dt / inductance_h;
        if (!high[k] && !low[k] && i[k] * mean < 0.0) mean = 0.0;
        i[k] = mean;
      end else i[k] = 0.0;
    end
    mean = i[0] + i[1] + i[2];
    many = 0;
    for (int k = 0; k < 3; k++) if (i[k] != 0.0) many = many + 1;
    for (int k = 0; k < 3; k++) if (i[k] != 0.0) i[k] = many > 1 ? i[k] - mean / many : 0.0;

    torque = 0.0;
    shunt = 0.0;
    for (int k = 0; k < 3; k++) begin
      torque = torque + pole_pairs * flux_vs * i[k] * s[k];
      if (high[k] || (!low[k] && i[k] < 0.0)) shunt = shunt + i[k];
      if (i[k] > peak_a) peak_a = i[k];
      if (-i[k] > peak_a) peak_a = -i[k];
    end
    // Dry friction and load hold a rotor that is slower than they would stop in one step.
    drag = coulomb_nm + load_nm;
    torque = torque - viscous_nms * speed;
    if (speed * inertia_kgm2 > drag * dt) torque = torque - drag;
    else if (speed * inertia_kgm2 < -drag * dt) torque = torque + drag;
    else if (torque > drag) torque = torque - drag;
    else if (torque < -drag) torque = torque + drag;
    else torque = -speed * inertia_kgm2 / dt;
    speed = speed + torque * dt / inertia_kgm2;
    rpm = speed * 30.0 / kPi;
    theta = theta + pole_pairs * speed * dt;
    if (theta > 2.0 * kPi) theta = theta - 2.0 * kPi;
    if (theta < 0.0) theta = theta + 2.0 * kPi;

    mean = (v[0] + v[1] + v[2]) / 3.0;
    for (int k = 0; k < 3; k++) comparator[k] <= v[k] > mean;
    limit <= shunt > limit_a;
  endtask

  always @(posedge clk) begin
    clocks <= clocks + 1;
    if (clocks % step_clocks == 0) begin
      dt = pace * step_clocks / clock_hz;
      step;
    end
  end
endmodule
