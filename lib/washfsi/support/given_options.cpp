// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/given_options.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "washfsi/support/text.hpp"

namespace washfsi {

std::string GivenOption::name() const {
  return lower_case(word.substr(word.find_first_not_of('-')));
}

const GivenOption* GivenOptions::last(const std::string& name) const {
  const auto found = std::find_if(options_.rbegin(), options_.rend(),
                                  [&](const GivenOption& option) { return option.name() == lower_case(name); });
  return found == options_.rend() ? nullptr : &*found;
}

std::string GivenOptions::value(const std::string& name) const {
  const GivenOption* option = last(name);
  return option ? option->value : "";
}

bool GivenOptions::on_command_line(const std::string& name) const {
  const GivenOption* option = last(name);
  return option && option->file.empty();
}

bool GivenOptions::lacks_value(const std::string& name) const {
  const GivenOption* option = last(name);
  return option && !option->has_value;
}

bool GivenOptions::is_recorded(const std::string& name) const {
  const GivenOption* option = last(name);
  return option && option->recorded;
}

std::string GivenOptions::resolve(const std::string& name, const std::string& path) const {
  const GivenOption* option = last(name);
  if (path.empty() || !option || option->file.empty()) return path;
  return (std::filesystem::path(option->file).parent_path() / path).string();  // an absolute path stays
}

std::vector<std::string> GivenOptions::dropped(const std::string& list, const std::vector<std::string>& present) const {
  std::vector<std::string> names;
  const auto in = [](const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  for (const GivenOption& option : options_) {
    if (option.name() != lower_case(list)) continue;
    for (const std::string& name : split(option.value, ','))
      if (!name.empty() && !in(present, name) && !in(names, name)) names.push_back(name);
  }
  return names;
}

bool GivenOptions::overridden(const std::string& name, const std::string& prefix) const {
  const GivenOption* present = last(name);
  if (!present) return false;
  return std::any_of(options_.data(), present, [&](const GivenOption& before) {
    return before.name() == present->name() ? before.value != present->value
                                            : before.name().starts_with(prefix) && before.file != present->file;
  });
}

bool GivenOptions::given_elsewhere_after(const std::string& name, const std::string& other) const {
  const GivenOption *one = last(name), *later = last(other);
  return one && later && later > one && later->file != one->file;
}

std::string GivenOptions::packed() const {
  std::string text;
  for (const GivenOption& option : options_)
    for (const std::string& part : {option.word, option.value, std::string(option.has_value ? "1" : ""), option.file,
                                    std::string(option.recorded ? "1" : "")})
      text += part + '\0';
  return text;
}

GivenOptions GivenOptions::unpacked(const std::string& text) {
  GivenOptions given;
  std::istringstream parts(text);
  GivenOption option;
  for (std::string has_value, recorded; std::getline(parts, option.word, '\0');) {
    std::getline(parts, option.value, '\0');
    std::getline(parts, has_value, '\0');
    std::getline(parts, option.file, '\0');
    std::getline(parts, recorded, '\0');
    option.has_value = !has_value.empty();
    option.recorded = !recorded.empty();
    given.add(option);
  }
  return given;
}

}  // namespace washfsi
