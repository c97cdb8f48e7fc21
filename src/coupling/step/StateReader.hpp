// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/ByteReader.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace tokay::coupling {

/// Reads what StateWriter wrote. Each call throws channel::PeerError if the bytes that
/// remain are not such a value.
class StateReader {
  public:
    /// @param bytes  is kept by reference
    explicit StateReader(const std::vector<std::uint8_t>& bytes)
        : read_(bytes.data(), bytes.size()) {}

    /// The interface is numbered anew since the state was written.
    /// @param sources  for each component of the interface now, its number in
    ///                 what is read
    void renumberInterface(std::vector<int> sources) { sources_ = std::move(sources); }

    double number() {
        double value = 0;
        read_(value);
        return value;
    }
    int integer() {
        std::uint32_t value = 0;
        read_(value);
        return static_cast<int>(value);
    }
    std::string text() {
        std::string value;
        read_(value);
        return value;
    }
    Eigen::MatrixXd matrix() {
        const int nRows = integer();
        const int nColumns = integer();
        if (nRows < 0 || nColumns < 0) {
            throw channel::PeerError("a matrix has a negative size");
        }
        std::vector<double> values;
        read_(values);
        if (values.size() != static_cast<std::size_t>(nRows) * static_cast<std::size_t>(nColumns)) {
            throw channel::PeerError("a matrix has another number of values than its size says");
        }
        return Eigen::Map<const Eigen::MatrixXd>(values.data(), nRows, nColumns);
    }
    Eigen::VectorXd vector() { return matrix().reshaped(); }

    /// A matrix with a row a component of the interface, as these are numbered now.
    Eigen::MatrixXd interfaceMatrix() {
        const Eigen::MatrixXd values = matrix();
        if (sources_.empty() || values.size() == 0) {
            return values;
        }
        if (values.rows() != static_cast<Eigen::Index>(sources_.size())) {
            throw channel::PeerError(
                "a state has another number of interface components than the fluid");
        }
        return values(sources_, Eigen::all);
    }
    Eigen::VectorXd interfaceVector() { return interfaceMatrix().reshaped(); }

    std::size_t remaining() const { return read_.remaining(); }

  private:
    channel::ByteReader read_;
    std::vector<int> sources_;
};

} // namespace tokay::coupling
