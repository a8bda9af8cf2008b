// What the printed ..._ports.hpp headers share: numbers of a block <-> ports of a Verilated module.
//
// A number is a bool, an integer, an enumeration, or a class with raw() and of() (Bits<W, S>).  A
// port is an unsigned integer, or an array of 32-bit words where it is wider than 64 bits.  A
// signed number arrives at its port as the lower bits of its two's complement.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/ports_test.cpp

#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace steplock::ports {

__extension__ using Word = unsigned __int128;

constexpr Word masked(Word word, int width) {
  return width >= 128 ? word : word & ((Word{1} << width) - 1);
}

template <class Number>
constexpr Word word_of(const Number& number, int width) {
  if constexpr (requires { number.raw(); }) {
    return masked(static_cast<Word>(number.raw()), width);
  } else {
    return masked(static_cast<Word>(number), width);
  }
}

template <class Number>
constexpr void set_number(Number& number, Word word) {
  if constexpr (requires { Number::of(word); }) {
    number = Number::of(word);
  } else {
    number = static_cast<Number>(word);
  }
}

template <class Port>
constexpr void set_port(Port& port, Word word) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(word);
  } else {
    for (std::size_t i = 0; i < sizeof(Port) / 4; ++i) {
      port[i] = static_cast<std::uint32_t>(word >> (32 * i));
    }
  }
}

template <class Port>
constexpr Word word_at(const Port& port) {
  if constexpr (std::is_integral_v<Port>) {
    return port;
  } else {
    Word word = 0;
    for (std::size_t i = 0; i < sizeof(Port) / 4; ++i) word |= Word{port[i]} << (32 * i);
    return word;
  }
}

}  // namespace steplock::ports
