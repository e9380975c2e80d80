#pragma once

#include <chrono>
#include <string>

#include "subjects/subject.hpp"

namespace rayaudit {

/// How long a program may neither read nor say anything where nothing else is asked for.
inline constexpr std::chrono::seconds usual_patience{10};

/// The subject that a shell command of one word or more is. Case lines go to its standard input; on
/// its standard output the same cases are to come back, in their order, each with its answer
/// appended, the last of them by the end of its input. Each batch is a run of its own, any number
/// of them at once.
///
/// It answers every shape. A first batch of a shape, be it empty, is put off until one easy case of
/// it has been answered. Throws Error where the command cannot be started, and NoAnswer where it
/// does not keep to this; but where it dies or hangs over some cases, those are found by asking
/// parts of the batch again, and have crashed or timed_out for an answer.
Subject program_subject(const std::string& command, const Format& format,
                        std::chrono::milliseconds patience = usual_patience);

}  // namespace rayaudit
