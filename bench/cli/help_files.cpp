#include "bench/cli/help_files.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

namespace arcway::internal::cli {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

// Options by their long names; of positional arguments none.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : command.get_options())
    if (!option->get_lnames().empty()) options.push_back(option);
  return options;
}

// Text for troff: no escapes, and no line that begins with a control character.
std::string for_man(const std::string& text) {
  std::string out = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  out = replaced(replaced(out, "\n.", "\n\\&."), "\n'", "\n\\&'");
  return out.starts_with(".") || out.starts_with("'") ? "\\&" + out : out;
}

std::string man_options(const CLI::App& command) {
  std::string out;
  for (const CLI::Option* option : command.get_options()) {
    const std::string value = option->get_type_size() == 0 || option->get_positional() ? "" : option->get_type_name();
    out += ".TP\n\\fB" + for_man(option->get_name(option->get_positional(), true)) + "\\fR" +
           (value.empty() ? "" : " \\fI" + for_man(value) + "\\fR") + "\n" + for_man(option->get_description());
    if (!option->get_default_str().empty()) out += for_man(" [" + option->get_default_str() + "]");
    out += "\n";
  }
  return out;
}

std::string words_of(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : options_of(command))
    for (const std::string& name : option->get_lnames()) words += (words.empty() ? "--" : " --") + name;
  return words;
}

// Text in single quotes for zsh's _arguments: no brackets, colons and quotes.
std::string for_zsh(std::string text) {
  for (const auto& [from, to] : {std::pair{"\\", "\\\\"}, {"[", "\\["}, {"]", "\\]"}, {":", "\\:"}, {"'", "'\\''"}})
    text = replaced(std::move(text), from, to);
  return replaced(std::move(text), "\n", " ");
}

int print_help_file(const CLI::App& app, const std::string& kind, std::string& out) {
  if (kind == "--man") {
    out += man_page(app);
  } else if (kind == "--bash") {
    out += bash_completion(app);
  } else {
    out += zsh_completion(app);
  }
  return kExitSolved;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string title = app.get_name();
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::string name = for_man(app.get_name());
  std::string out = ".TH " + title + " 1\n.SH NAME\n" + name + " \\- " + for_man(app.get_description()) +
                    "\n.SH SYNOPSIS\n\\fB" + name + "\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app))
    out += ".TP\n\\fB" + for_man(command->get_name()) + "\\fR\n" + for_man(command->get_description()) + "\n";
  for (const CLI::App* command : commands_of(app)) {
    out += ".SH \"" + name + " " + for_man(command->get_name()) + "\"\n" + for_man(command->get_description()) + "\n" +
           man_options(*command);
    if (!command->get_footer().empty()) out += ".PP\n.nf\n" + for_man(command->get_footer()) + "\n.fi\n";
  }
  return out + ".SH NOTES\n.nf\n" + for_man(app.get_footer()) + "\n.fi\n";
}

std::string bash_completion(const CLI::App& app) {
  const std::string name = app.get_name(), function = "_" + name;
  std::string commands;
  for (const CLI::App* command : commands_of(app)) commands += (commands.empty() ? "" : " ") + command->get_name();
  std::string out = "# Completion of " + name + " for bash, made by: " + name + " help --bash\n" + function + "() {\n" +
                    "  local word=${COMP_WORDS[COMP_CWORD]}\n  COMPREPLY=()\n" +
                    "  if ((COMP_CWORD == 1)); then\n    COMPREPLY=($(compgen -W \"" + commands +
                    " --help --version\" -- \"$word\"))\n    return\n  fi\n  local options\n" +
                    "  case ${COMP_WORDS[1]} in\n    help) COMPREPLY=($(compgen -W \"" + commands +
                    "\" -- \"$word\")); return ;;\n";
  for (const CLI::App* command : commands_of(app))
    if (command->get_name() != "help")
      out += "    " + command->get_name() + ") options=\"" + words_of(*command) + "\" ;;\n";
  return out + "  esac\n  if [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n" +
         "  else\n    compopt -o filenames 2>/dev/null\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\n" +
         "complete -F " + function + " " + name + "\n";
}

std::string zsh_completion(const CLI::App& app) {
  const std::string name = app.get_name();
  std::string out = "#compdef " + name + "\n# Completion of " + name + " for zsh, made by: " + name + " help --zsh\n_" +
                    name + "() {\n  local -a commands\n  commands=(\n";
  for (const CLI::App* command : commands_of(app))
    out += "    '" + command->get_name() + ":" + for_zsh(command->get_description()) + "'\n";
  out += "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n  case $words[2] in\n" +
         std::string("    help) _describe command commands ;;\n");
  for (const CLI::App* command : commands_of(app)) {
    if (command->get_name() == "help") continue;
    out += "    " + command->get_name() + ")\n      _arguments -S";
    for (const CLI::Option* option : options_of(*command)) {
      const bool has_value = option->get_type_size() != 0;
      for (const std::string& word : option->get_lnames())
        out += " \\\n        '*--" + word + "[" + for_zsh(option->get_description()) + "]" +
               (has_value ? ":" + for_zsh(option->get_type_name()) + ":_files" : "") + "'";
    }
    out += " \\\n        '*:file:_files' ;;\n";
  }
  return out + "  esac\n}\n_" + name + " \"$@\"\n";
}

void add_help_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("help", "Explain a command: arcway help plan");
  const auto kind = std::make_shared<std::string>();
  for (const char* name : {"--man", "--bash", "--zsh"}) {
    const std::string what =
        std::string(name) == "--man" ? "Print the manual page" : std::string("Print completions for ") + (name + 2);
    command.add_flag_callback(
        name, [kind, name] { *kind = name; }, what);
  }
  command.callback([&app, kind, &action] {
    action = [&app, kind](std::string& out) {
      if (kind->empty()) throw UsageError("help: one command at a time, as in: arcway help plan");
      return print_help_file(app, *kind, out);
    };
  });
}

}  // namespace arcway::internal::cli
