#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/help.hpp"
#include "new_deck.hpp"
#include "shell_files.hpp"

namespace ndframe
{

namespace
{

/// What a shell may offer: options, what --help knows, entries of the deck that need no name of the user's.
struct Words
{
  std::vector<const CLI::Option*> options;
  std::vector<std::string> helpNames, paths;
};

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::vector<std::string> names(const CLI::Option& option)
{
  std::vector<std::string> all;
  for (const auto& name : option.get_snames())
    all.push_back("-" + name);
  for (const auto& name : option.get_lnames())
    all.push_back("--" + name);
  return all;
}

/// A sentence for shells that show one, without what would have to be quoted.
std::string brief(const CLI::Option& option)
{
  std::string text = option.get_description();
  text = text.substr(0, std::min(text.find(", e.g."), text.find(". ")));
  for (const char* special : {"'", "\"", "[", "]", ":", "`", "\\", "$"})
    text = replaced(text, special, "");
  return text;
}

std::string lines(const std::vector<std::string>& words)
{
  return fmt::format("{}", fmt::join(words, "\n"));
}

std::vector<std::string> allNames(const Words& words)
{
  std::vector<std::string> all;
  for (const CLI::Option* option : words.options)
    for (auto& name : names(*option))
      all.push_back(std::move(name));
  return all;
}

std::string bash(const Words& words)
{
  return fmt::format(R"sh(# bash completion of ndframe, written by `ndframe --completion bash`
_ndframe_lines() {{ # offers the lines of the text $1; those with spaces are quoted
  local IFS=$'\n' word=${{2//\\ / }}
  COMPREPLY=($(compgen -W "$1" -- "$word"))
  COMPREPLY=("${{COMPREPLY[@]// /\\ }}")
}}
_ndframe() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local options='{}'
  local names='{}'
  local paths='{}'
  COMPREPLY=()
  case $before in
    -h|--help) _ndframe_lines "$names" "$word" ;;
    --completion) _ndframe_lines $'bash\nzsh\nfish' "$word" ;;
    --set|--study) compopt -o nospace 2>/dev/null; _ndframe_lines "$paths" "$word" ;;
    report) COMPREPLY=($(compgen -f -X '!*.summary.json' -- "$word") $(compgen -f -X '!*.study.csv' -- "$word")) ;;
    new) _ndframe_lines '{}' "$word" ;;
    from-geo) COMPREPLY=($(compgen -f -X '!*.geo' -- "$word") $(compgen -f -X '!*.msh' -- "$word")) ;;
    *)
      if [[ $word == -* ]]; then
        _ndframe_lines "$options" "$word"
      else
        COMPREPLY=($(compgen -f -X '!*.xml' -- "$word") $(compgen -d -S / -- "$word") $(compgen -W "new report" -- "$word"))
        [[ ${{COMPREPLY[0]}} == */ ]] && compopt -o nospace 2>/dev/null
      fi ;;
  esac
}}
complete -F _ndframe ndframe
)sh",
                     lines(allNames(words)), lines(words.helpNames), lines(words.paths), lines(templateNames()));
}

std::string zshArgument(const CLI::Option& option)
{
  const std::map<std::string, std::string> actions{{"help", ": :_ndframe_names"},
                                                   {"set", ": :_ndframe_paths"},
                                                   {"study", ": :_ndframe_paths"},
                                                   {"input", ": :_files -g \"*.xml\""},
                                                   {"completion", ": :(bash zsh fish)"}};
  const auto all = names(option);
  const auto action = option.get_lnames().empty() ? actions.end() : actions.find(option.get_lnames().front());
  std::string text;
  for (const auto& name : all)
    text += fmt::format("    '*{}[{}]{}' \\\n", name, brief(option), action == actions.end() ? "" : action->second);
  return text;
}

std::string zsh(const Words& words)
{
  std::string arguments;
  for (const CLI::Option* option : words.options)
    arguments += zshArgument(*option);
  return fmt::format(R"sh(#compdef ndframe
# zsh completion of ndframe, written by `ndframe --completion zsh`
_ndframe_names() {{
  local -a all=("${{(@f)$(print -r -- '{}')}}")
  compadd -a all
}}
_ndframe_paths() {{
  local -a all=("${{(@f)$(print -r -- '{}')}}")
  compadd -S '' -a all
}}
_ndframe() {{
  if [[ ${{words[2]}} == report ]]; then
    _files -g "*.(summary.json|study.csv)"
    return
  elif [[ ${{words[2]}} == new ]]; then
    (( CURRENT == 3 )) && compadd {} || _files -g "*.(geo|msh)"
    return
  fi
  _arguments \
{}    '1: :{{ compadd new report; _files -g "*.xml" }}'
}}
_ndframe "$@"
)sh",
                     lines(words.helpNames), lines(words.paths), fmt::join(templateNames(), " "), arguments);
}

std::string fishOption(const CLI::Option& option)
{
  const std::map<std::string, std::string> arguments{{"help", "-x -a \"(__ndframe_names)\""},
                                                     {"set", "-x -a \"(__ndframe_paths)\""},
                                                     {"study", "-x -a \"(__ndframe_paths)\""},
                                                     {"input", "-r -k -a \"(__fish_complete_suffix .xml)\""},
                                                     {"completion", "-x -a \"bash zsh fish\""}};
  std::string text = "complete -c ndframe";
  for (const auto& name : option.get_snames())
    text += " -s " + name;
  for (const auto& name : option.get_lnames())
    text += " -l " + name;
  const auto found = option.get_lnames().empty() ? arguments.end() : arguments.find(option.get_lnames().front());
  return text + fmt::format(" -d '{}'{}\n", brief(option), found == arguments.end() ? "" : " " + found->second);
}

std::string fish(const Words& words)
{
  std::string text =
      fmt::format(R"sh(# fish completion of ndframe, written by `ndframe --completion fish`
function __ndframe_names
  printf '%s\n' '{}'
end
function __ndframe_paths
  printf '%s\n' '{}'
end
complete -c ndframe -n __fish_use_subcommand -a report -d 'Write one page of what a run has left'
complete -c ndframe -n __fish_use_subcommand -a new -d 'Write a commented deck to begin with'
complete -c ndframe -n '__fish_seen_subcommand_from new' -x -a '{}'
complete -c ndframe -n '__fish_seen_subcommand_from from-geo' -a "(__fish_complete_suffix .geo) (__fish_complete_suffix .msh)"
complete -c ndframe -n __fish_use_subcommand -k -a "(__fish_complete_suffix .xml)"
)sh",
                  fmt::join(words.helpNames, "' '"), fmt::join(words.paths, "' '"), fmt::join(templateNames(), " "));
  for (const CLI::Option* option : words.options)
    text += fishOption(*option);
  return text;
}

} // namespace

std::string completionScript(const std::string& shell, const CLI::App& app, const ListSpec& deck)
{
  const std::map<std::string, std::function<std::string(const Words&)>> shells{
      {"bash", bash}, {"zsh", zsh}, {"fish", fish}};
  const auto found = shells.find(shell);
  if (found == shells.end())
    throw InputError(fmt::format("--completion: there is no script for \"{}\"; there are bash, zsh and fish.", shell));
  Words words;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_snames().empty() || !option->get_lnames().empty())
      words.options.push_back(option);
  words.helpNames = listAndComponentNames(deck);
  words.helpNames.emplace_back("new");
  words.helpNames.emplace_back("report");
  for (const auto& path : parameterPaths(deck))
    words.paths.push_back(path + "=");
  return found->second(words);
}

std::string forShell(const std::string& word)
{
  const bool isPlain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) != 0 || std::string_view("._-+/").find(char(c)) != std::string_view::npos;
  });
  return isPlain ? word : "'" + replaced(word, "'", "'\\''") + "'";
}

} // namespace ndframe
