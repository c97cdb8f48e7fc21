// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/readToken.hpp"

#include "common/errors.hpp"

#include <sys/stat.h>

#include <fstream>
#include <sstream>

namespace tokay::channel {
namespace {

void requirePrivate(const std::string& fileName) {
    struct stat status;
    if (stat(fileName.c_str(), &status) == 0 && (status.st_mode & 077) != 0) {
        std::ostringstream mode;
        mode << std::oct << (status.st_mode & 0777);
        throw InputError("the token file '" + fileName + "' is open to other users (mode " +
                         mode.str() + "): make it yours alone by 'chmod 600 " + fileName +
                         "', and write another secret if they may have read it");
    }
}

} // namespace

std::string readToken(const std::string& fileName) {
    requirePrivate(fileName);
    const char* whiteSpace = " \t\r";
    std::ifstream file(fileName);
    std::string line;
    std::getline(file, line);
    const std::size_t first = line.find_first_not_of(whiteSpace);
    if (first == std::string::npos) {
        throw InputError("the token file '" + fileName +
                         "' cannot be read or has an empty first line");
    }
    return line.substr(first, line.find_last_not_of(whiteSpace) - first + 1);
}

} // namespace tokay::channel
