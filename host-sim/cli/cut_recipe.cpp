#include "host-sim/cli/cut_recipe.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cut/json_fields.hpp"
#include "host-sim/report/nearest_name.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRecipeMark = "kerfline_recipe";
constexpr const char* kLayersKey = "layers";
/// Key of `--layers FILE`. The option's own name is already the key of the list of layers.
constexpr const char* kLayersFileKey = "layers-file";

/// Returns whether an option cannot be part of a recipe, because it names a file of the call or is
/// no setting of a job.
bool is_of_the_call(const CLI::Option& option) {
  constexpr std::array<const char*, 4> kNames{"help", "recipe", "save-recipe", "layer"};
  if (option.get_positional() || option.get_lnames().empty()) return true;
  const std::string& name = option.get_lnames().front();
  return std::ranges::find(kNames, name) != kNames.end() || file_role(option) == FileRole::kOutput;
}

std::string key_of(const CLI::Option& option) {
  const std::string& name = option.get_lnames().front();
  return name == kLayersKey ? kLayersFileKey : name;
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

std::vector<std::string> keys_of(const CLI::App& command) {
  std::vector<std::string> keys{kRecipeMark, kLayersKey};
  for (const CLI::Option* option : command.get_options()) {
    if (!is_of_the_call(*option)) keys.push_back(key_of(*option));
  }
  return keys;
}

/// Returns the name of a file relative to another folder. Names of shipped files are unchanged.
std::string from_folder(const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path path{name};
  if (path.is_absolute() || !path.has_extension()) return name;
  return (folder / path).lexically_normal().string();
}

std::string to_folder(const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path path{name};
  if (path.is_absolute() || !path.has_extension()) return name;
  const auto absolute = [](const std::filesystem::path& each) {
    return std::filesystem::absolute(each).lexically_normal();
  };
  return absolute(path).lexically_proximate(absolute(folder.empty() ? "." : folder)).string();
}

/// Applies a recipe to the options of a call.
class RecipeReader {
 public:
  RecipeReader(CLI::App& command, CutCommandOptions& options)
      : command_{command},
        options_{options},
        file_{options.recipe.file},
        folder_{std::filesystem::path{options.recipe.file}.parent_path()} {}

  void read() {
    const Json document =
        cut::marked_json(read_text(file_), name_of_input(file_), kRecipeMark, "recipe");
    const std::vector<std::string> keys = keys_of(command_);
    const cut::JsonFields fields{document, name_of_input(file_), "", keys};
    // The rules for layers are read first. Thus a file of layers in the same recipe is no conflict,
    // whichever of the two keys comes first.
    if (document.contains(kLayersKey)) read_layers(document[kLayersKey]);
    for (const auto& [key, value] : document.items()) {
      if (key == kRecipeMark || key == kLayersKey) continue;
      take(option_of(key), key, value);
    }
    expect_needed();
  }

 private:
  [[noreturn]] void refuse(const std::string& pointer, const std::string& reason) const {
    throw std::invalid_argument(
        fmt::format("{}: {}: {}", name_of_input(file_), printable_line(pointer), reason));
  }

  CLI::Option& option_of(const std::string& key) {
    return *command_.get_option("--" + (key == kLayersFileKey ? kLayersKey : key));
  }

  /// Returns the words with which the command line would give the value.
  std::vector<std::string> words_of(const CLI::Option& option,
                                    const std::string& pointer,
                                    const Json& value) const {
    if (value.is_array() && option.get_items_expected_max() > 1) {
      std::vector<std::string> words;
      for (std::size_t i = 0; i < value.size(); ++i) {
        words.push_back(word_of(option, fmt::format("{}/{}", pointer, i), value[i]));
      }
      return words;
    }
    return {word_of(option, pointer, value)};
  }

  std::string word_of(const CLI::Option& option,
                      const std::string& pointer,
                      const Json& value) const {
    if (value.is_number()) return value.dump();
    if (!value.is_string()) refuse(pointer, "must be a text or a number");
    const auto word = value.get<std::string>();
    return file_role(option) ? from_folder(word, folder_) : word;
  }

  void take(CLI::Option& option, const std::string& key, const Json& value) {
    const std::string pointer = "/" + key;
    if (is_flag(option)) {
      if (!value.is_boolean()) refuse(pointer, "must be true or false");
      if (value.get<bool>() && option.count() == 0) give(option, pointer, {"true"});
      return;
    }
    std::vector<std::string> words = words_of(option, pointer, value);
    if (option.count() == 0) return give(option, pointer, words);
    if (option.get_items_expected_max() <= 1) return;
    words.insert(words.end(), option.results().begin(), option.results().end());
    option.clear();
    give(option, pointer, words);
  }

  void give(CLI::Option& option,
            const std::string& pointer,
            const std::vector<std::string>& words) {
    try {
      for (const std::string& word : words) option.add_result(word);
      option.run_callback();
    } catch (const CLI::Error& error) {
      refuse(pointer, error.what());
    }
  }

  /// Reads `{"NAME": {"key": value}}`, or a list of objects `{"name": "NAME", "key": value}`.
  void read_layers(const Json& layers) {
    if (!options_.layers_file.empty()) {
      refuse("/layers", "excludes the option --layers; leave one out, or give --layer");
    }
    const std::string pointer = fmt::format("/{}", kLayersKey);
    if (layers.is_object()) {
      for (const auto& [name, settings] : layers.items()) {
        read_layer(name, settings, fmt::format("{}/{}", pointer, name));
      }
      return;
    }
    if (!layers.is_array())
      refuse(pointer, R"(must be an object, such as {"NAME": {"kind": "cut"}})");
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const std::string place = fmt::format("{}/{}", pointer, i);
      if (!layers[i].is_object() || !layers[i].contains("name") || !layers[i]["name"].is_string()) {
        refuse(place, R"(must be an object with "name")");
      }
      Json settings = layers[i];
      settings.erase("name");
      read_layer(layers[i]["name"].get<std::string>(), settings, place);
    }
  }

  void read_layer(const std::string& name, const Json& settings, const std::string& pointer) {
    if (!settings.is_object()) refuse(pointer, R"(must be an object, such as {"kind": "engrave"})");
    cut::LayerRule rule{
        name, {}, fmt::format("{}: {}", name_of_input(file_), printable_line(pointer))};
    cut::LayerSettings tried;
    for (const auto& [key, value] : settings.items()) {
      if (!value.is_string() && !value.is_number()) {
        refuse(fmt::format("{}/{}", pointer, key), "must be a text or a number");
      }
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      try {
        set(tried, key, text);
      } catch (const std::invalid_argument& error) {
        refuse(fmt::format("{}/{}", pointer, key), error.what());
      }
      rule.values.emplace_back(key, text);
    }
    options_.recipe.layers.push_back(std::move(rule));
  }

  /// Checks the options that require or exclude each other. The parser cannot check them, because
  /// it has not seen the options of the recipe.
  void expect_needed() const {
    for (const CLI::Option* option : command_.get_options()) {
      if (option->count() == 0 || is_of_the_call(*option)) continue;
      for (const CLI::Option* needed : option->get_needs()) {
        if (needed->count() == 0) {
          refuse("/" + key_of(*option), fmt::format("requires {}, too", needed->get_name()));
        }
      }
      for (const CLI::Option* excluded : option->get_excludes()) {
        if (excluded->count() != 0) {
          refuse("/" + key_of(*option),
                 fmt::format("excludes {}; leave one out", excluded->get_name()));
        }
      }
    }
  }

  CLI::App& command_;
  CutCommandOptions& options_;
  std::string file_;
  std::filesystem::path folder_;
};

/// Returns a text as a JSON number if that number is printed as the same text; otherwise as a JSON
/// string.
Json value_of(const std::string& text) {
  const Json number = Json::parse(text, nullptr, false);
  return number.is_number() && number.dump() == text ? number : Json(text);
}

/// Returns the words of an option. An option with choices stores the number of its choice, which
/// becomes the word again.
std::vector<std::string> words_of(const CLI::Option& option, const CutCommandOptions& options) {
  const std::string& name = option.get_lnames().front();
  if (name == "order") return {std::string{order::name_of(options.order.method)}};
  if (name == "cost") return {std::string{cut::text_of(options.order.cost)}};
  if (name == "group") return {std::string{cut::text_of(options.order.grouping)}};
  if (name == "fit") return {std::string{name_of(options.curves.method)}};
  if (name == "frame-shape") {
    return {options.frame.shape == cut::FrameShape::kHull ? "hull" : "box"};
  }
  return option.results();
}

Json values_of(const CLI::Option& option,
               const CutCommandOptions& options,
               const std::filesystem::path& folder) {
  if (is_flag(option)) return true;
  std::vector<Json> values;
  for (const std::string& word : words_of(option, options)) {
    values.push_back(file_role(option) ? Json(to_folder(word, folder)) : value_of(word));
  }
  return values.size() == 1 ? values.front() : Json(values);
}

/// Returns the rules for layers as an object, or as a list if a name occurs twice.
Json layers_json(const std::vector<cut::LayerRule>& rules) {
  std::set<std::string> names;
  for (const cut::LayerRule& rule : rules) names.insert(rule.name);
  const bool is_list = names.size() != rules.size();
  Json layers = is_list ? Json::array() : Json::object();
  for (const cut::LayerRule& rule : rules) {
    Json settings = Json::object();
    if (is_list) settings["name"] = rule.name;
    for (const auto& [key, value] : rule.values) settings[key] = value_of(value);
    if (is_list) {
      layers.push_back(std::move(settings));
    } else {
      layers[rule.name] = std::move(settings);
    }
  }
  return layers;
}

}  // namespace

void add_cut_recipe_options(CLI::App& command, CutCommandOptions& options) {
  mark_file(command
                .add_option("--recipe",
                            options.recipe.file,
                            "File of any of these options as JSON; options of the call override it")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(
      command
          .add_option(
              "--save-recipe", options.recipe.save, "Write the options of this call as a recipe")
          ->type_name("FILE"),
      FileRole::kOutput);
}

void apply_recipe(CLI::App& command, CutCommandOptions& options) {
  if (options.recipe.file.empty()) return;
  RecipeReader{command, options}.read();
  refuse_shared_files(command);
}

void save_recipe(const CLI::App& command, const CutCommandOptions& options) {
  if (options.recipe.save.empty()) return;
  const std::filesystem::path folder = std::filesystem::path{options.recipe.save}.parent_path();
  Json recipe{{kRecipeMark, 1}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || is_of_the_call(*option)) continue;
    recipe[key_of(*option)] = values_of(*option, options, folder);
  }
  std::vector<cut::LayerRule> rules = options.recipe.layers;
  for (const std::string& text : options.layers) rules.push_back(cut::parse_rule(text, "--layer"));
  if (!rules.empty()) recipe[kLayersKey] = layers_json(rules);
  write_file(options.recipe.save, dumped(std::move(recipe)) + "\n");
}

}  // namespace sim
