// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace tokay {

/// The action must throw an InputError whose message contains each of the words.
inline void expectInputError(const std::function<void()>& action,
                             const std::vector<std::string>& words) {
    try {
        action();
        ADD_FAILURE() << "nothing was thrown";
    } catch (const InputError& error) {
        const std::string message = error.what();
        for (const std::string& word : words) {
            EXPECT_NE(message.find(word), std::string::npos)
                << "\"" << word << "\" is missing in: " << message;
        }
    }
}

} // namespace tokay
