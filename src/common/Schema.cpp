// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Schema.hpp"

#include <fmt/format.h>

namespace tokay {

namespace {

void requireInside(double value, const Entry& entry) {
    if (!entry.range.contains(value)) {
        throw InputError(entry.name + ": " + outOfRange(fmt::format("{:g}", value), entry));
    }
}

} // namespace

Schema Schema::in(const std::function<void*(void*)>& part) const {
    Schema moved;
    for (Entry entry : entries) {
        entry.slot = [part, slot = entry.slot](void* options) { return slot(part(options)); };
        entry.isSet = [part, isSet = entry.isSet](void* options) { return isSet(part(options)); };
        for (Alternative& alternative : entry.alternatives) {
            alternative.own = alternative.own.in(part);
        }
        moved.entries.push_back(std::move(entry));
    }
    return moved;
}

std::vector<const Entry*> Schema::entriesOf(void* options) const {
    std::vector<const Entry*> all;
    for (const Entry& entry : entries) {
        all.push_back(&entry);
        if (!entry.alternatives.empty() && entry.isSet(options)) {
            for (const std::size_t k : std::get<ChoiceSlot>(entry.slot(options)).get()) {
                for (const Entry* own : entry.alternatives.at(k).own.entriesOf(options)) {
                    all.push_back(own);
                }
            }
        }
    }
    return all;
}

std::string outOfRange(const std::string& value, const Entry& entry) {
    return fmt::format("{} is out of range; allowed: {}{}", value, entry.range.text(),
                       entry.unit.empty() ? "" : " " + entry.unit);
}

void requireInRange(const Schema& schema, void* options) {
    for (const Entry* entry : schema.entriesOf(options)) {
        if (!entry->isSet(options)) {
            continue;
        }
        const Slot slot = entry->slot(options);
        if (const auto* number = std::get_if<double*>(&slot)) {
            requireInside(**number, *entry);
        } else if (const auto* integer = std::get_if<int*>(&slot)) {
            requireInside(**integer, *entry);
        } else if (const auto* section = std::get_if<Section>(&slot)) {
            requireInRange(*section->schema, section->options);
        }
    }
}

} // namespace tokay
