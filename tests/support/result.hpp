#ifndef LVSM_TESTS_SUPPORT_RESULT_HPP
#define LVSM_TESTS_SUPPORT_RESULT_HPP

#include <optional>
#include <string>
#include <utility>

namespace lvsm::support {

struct Failure {
  std::string message;
};

/// A value, or the reason why there is none.
template <typename T>
class Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Failure failure) : error_(std::move(failure.message)) {}

  explicit operator bool() const { return value_.has_value(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }
  const std::string& error() const { return error_; }

 private:
  std::optional<T> value_;
  std::string error_;
};

}  // namespace lvsm::support

#endif
