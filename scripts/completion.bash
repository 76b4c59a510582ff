# Completion for bash: options, parameter files, and the entries after --set, as
# the program itself lists them.

_thermocontact()
{
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local IFS=$'\n'
  case $before in
    --set)
      COMPREPLY=($(compgen -W "$("${COMP_WORDS[0]}" --print-parameters 2>/dev/null |
        awk '$1 == "subsection" { sub(/^ *subsection /, ""); section = $0 "/" }
             $1 == "end" { section = "" }
             $1 == "set" { sub(/^ *set /, ""); sub(/ *=.*/, "")
                           print section $0 "=" }')" -- "$word"))
      compopt -o nospace -o filenames 2>/dev/null
      ;;
    --output)
      COMPREPLY=($(compgen -d -- "$word"))
      compopt -o filenames 2>/dev/null
      ;;
    *)
      if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$("${COMP_WORDS[0]}" --help 2>/dev/null |
          grep -oE -- '--[a-z-]+' | sort -u)" -- "$word"))
      else
        COMPREPLY=($(compgen -f -X '!*.prm' -- "$word") $(compgen -d -S / -- "$word"))
        compopt -o nospace -o filenames 2>/dev/null
      fi
      ;;
  esac
}
complete -F _thermocontact thermocontact
