#include <fmt/format.h>

#include "reports/report.hpp"

namespace rayaudit {
namespace {

/// One line of fields, quoted as RFC 4180 has it where they need to be.
class Row {
 public:
  void add(std::string_view text) {
    if (!line_.empty()) line_ += ',';
    if (text.find_first_of(",\"\r\n") == text.npos) {
      line_ += text;
      return;
    }
    line_ += '"';
    for (const char letter : text) line_.append(letter == '"' ? 2 : 1, letter);
    line_ += '"';
  }
  void add(std::uint64_t count) { add(std::string_view(std::to_string(count))); }
  void add(double number) { add(std::string_view(fmt::format("{}", number))); }
  void add_nothing() { add(std::string_view()); }

  /// Largest and quantiles; empty where nothing was measured.
  void add(const Histogram& errors) {
    for (const double number : {errors.quantile(0.5), errors.quantile(0.99), errors.largest()})
      errors.count() > 0 ? add(number) : add_nothing();
  }

  /// How bad a worst case is; empty where there is none.
  void add(const Worst* worst) { worst != nullptr ? add(worst->severity) : add_nothing(); }

  std::string line() const { return line_ + '\n'; }

 private:
  std::string line_;
};

constexpr std::size_t kinds = std::tuple_size_v<decltype(Tally::touches)>;

std::string header() {
  Row row;
  for (const auto* column : {"subject", "format", "shape", "family", "cases", "wrong"})
    row.add(std::string_view(column));
  row.add(std::string_view("wrong_below_95"));
  for (std::size_t i = 0; i < verdict_count; ++i) row.add(name(static_cast<Verdict>(i)));
  for (std::size_t i = 1; i < claim_count; ++i)
    row.add("claim_" + std::string(name(static_cast<Claim>(i))));
  for (std::size_t i = 1; i < kinds; ++i)
    for (const auto* taken : {"_hit", "_miss"})
      row.add(std::string(name(static_cast<oracle::Kind>(i))) + taken);
  for (std::size_t i = 1; i < side_count; ++i)
    row.add("side_" + std::string(name(static_cast<Side>(i))));
  for (std::size_t i = 0; i < oracle::stage_count; ++i)
    row.add("decided_by_" + std::string(name(static_cast<oracle::Stage>(i))));
  for (const std::string errors : {"ulp_", "forced_", "distance_"})
    for (const auto* what : {"p50", "p99", "max"}) row.add(errors + what);
  for (std::size_t i = 0; i < cause_count; ++i)
    row.add("cause_" + std::string(name(static_cast<Cause>(i))));
  for (const auto* column : {"replayed", "largest_wrong_margin", "certified_share",
                             "certified_wrong", "proved_ulp", "observed_ulp"})
    row.add(std::string_view(column));
  return row.line();
}

std::string line(const Audit& audit) {
  const Tally& tally = audit.tally;
  Row row;
  row.add(audit.subject->name);
  row.add(audit.subject->format.name);
  row.add(shape_names[audit.shape]);
  row.add(audit.family->id);
  row.add(tally.cases);
  row.add(tally.wrong());
  // Where none of N is wrong, the share of wrong is below 3/N with 95 % confidence.
  tally.wrong() == 0 ? row.add(3 / static_cast<double>(tally.cases)) : row.add_nothing();
  for (const std::uint64_t count : tally.verdicts) row.add(count);
  for (std::size_t i = 1; i < claim_count; ++i) row.add(tally.of(static_cast<Claim>(i)));
  for (std::size_t i = 1; i < kinds; ++i) {
    row.add(tally.touches[i].taken);
    row.add(tally.touches[i].passed);
  }
  for (std::size_t i = 1; i < side_count; ++i) row.add(tally.sides[i]);
  for (const std::uint64_t count : tally.decided_by) row.add(count);
  for (const Histogram* errors : {&tally.ulps, &tally.forced, &tally.distance}) row.add(*errors);
  const CauseCount causes = tally.causes();
  for (std::size_t i = 0; i < cause_count; ++i) {
    const auto cause = static_cast<Cause>(i);
    row.add(cause == Cause::convention ? tally.of(Verdict::touch) : causes.of(cause));
  }
  row.add(causes.replayed());
  row.add(tally.widest());
  const Certificate& certificate = tally.certificate;
  certificate.cases == 0 ? row.add_nothing()
                         : row.add(static_cast<double>(certificate.certified) /
                                   static_cast<double>(certificate.cases));
  row.add(certificate.wrong);
  row.add(certificate.proved ? &*certificate.proved : nullptr);
  row.add(certificate.observed ? &*certificate.observed : nullptr);
  return row.line();
}

}  // namespace

std::string write_csv(const Run& run, const Look&) {
  std::string text = header();
  for (const Audit& audit : run.audits) text += line(audit);
  return text;
}

}  // namespace rayaudit
