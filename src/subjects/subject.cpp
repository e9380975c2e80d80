#include "subjects/subject.hpp"

#include <string_view>

namespace rayaudit {

bool is_letter_of_name(char letter) {
  return std::string_view("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+-.")
             .find(letter) != std::string_view::npos;
}

void answer_mixed(const Subject& subject, std::span<const Case> cases, std::span<Answer> answers) {
  for (std::size_t begin = 0; begin < cases.size();) {
    const std::size_t shape = cases[begin].shape.index();
    std::size_t end = begin + 1;
    while (end < cases.size() && cases[end].shape.index() == shape) ++end;
    subject.answer[shape](cases.subspan(begin, end - begin), answers.subspan(begin, end - begin));
    begin = end;
  }
}

Answer answer_one(const Subject& subject, const Case& question) {
  Answer said;
  subject.answer[question.shape.index()]({&question, 1}, {&said, 1});
  return said;
}

}  // namespace rayaudit
