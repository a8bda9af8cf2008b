// A second-order sigma-delta modulator in floating point, with the noise transfer function (1 - 1/z)^2, or one of
// the first order; and how well a sine is seen in samples.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace steplock {

class Modulator {
 public:
  explicit Modulator(int order = 2, unsigned seed = 1) : order_(order), any_(seed) {}

  // The next bit for an input within -1 .. 1 of full scale.
  bool bit(double input) {
    // Dither of 1 % keeps the quantiser's noise from repeating.
    const double v = order_ == 2 ? input - 2 * error_ + before_ : input - error_;
    const bool bit = v + std::uniform_real_distribution<>(-0.01, 0.01)(any_) >= 0;
    before_ = error_;
    error_ = (bit ? 1 : -1) - v;
    ++bits_;
    noise_ += error_ * error_;
    return bit;
  }
  // Of the quantiser so far; 1/3 if it were never overloaded.
  double noise() const { return noise_ / double(bits_); }

 private:
  int order_;
  std::mt19937 any_;
  double error_ = 0, before_ = 0, noise_ = 0;
  long bits_ = 0;
};

// Power of the sine of `turns` per sample over that of all else but a constant, in dB; over whole turns.
inline double snr_db(const std::vector<double>& samples, double turns) {
  const double n = double(samples.size());
  double mean = 0;
  for (const double x : samples) mean += x / n;
  double cosine = 0, sine = 0;
  const auto angle = [&](std::size_t k) { return 2 * M_PI * turns * double(k); };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    cosine += 2 / n * (samples[k] - mean) * std::cos(angle(k));
    sine += 2 / n * (samples[k] - mean) * std::sin(angle(k));
  }
  double noise = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double fit = mean + cosine * std::cos(angle(k)) + sine * std::sin(angle(k));
    noise += (samples[k] - fit) * (samples[k] - fit) / n;
  }
  return 10 * std::log10((cosine * cosine + sine * sine) / 2 / noise);
}

}  // namespace steplock
