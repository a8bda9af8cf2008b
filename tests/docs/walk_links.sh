#!/usr/bin/env bash
# walk_links.sh ROOT: from docs/index.md every page of docs/ can be reached, and no link of a page reached, nor of the
# pages beside README.md, is dead: the file is there, and behind a # the heading, too.  Links to other hosts are not asked.
set -euf -o pipefail
cd "$1"
declare -A seen anchors
failed=0 links=0
queue=(docs/index.md README.md CONTRIBUTING.md CHANGELOG.md)
headings() {  # of a page, as anchors: lower case, without punctuation, dashes for spaces
  awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print }' "$1" |
    sed -E 's/\[([^]]*)\]\([^)]*\)/\1/g' | tr '[:upper:]' '[:lower:]' | sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'
}
links_of() {  # line:target
  awk '/^```/ { code = !code } !code && !/^    / { gsub(/`[^`]*`/, "``"); print NR ":" $0 }' "$1" |
    { grep -oE '^[0-9]+|\]\([^) ]+\)' || true; } |
    awk '/^[0-9]+$/ { line = $0; next } { print line ":" substr($0, 3, length($0) - 3) }'
}
resolve() {  # PATH: `to`, without . and .. (a process for each of a thousand links would be slow)
  local parts=() part IFS=/
  for part in $1; do
    case $part in
      '' | .) ;;
      ..) if [ ${#parts[@]} -gt 0 ] && [ "${parts[-1]}" != .. ]; then unset 'parts[-1]'; else parts+=(..); fi ;;
      *) parts+=("$part") ;;
    esac
  done
  to="${parts[*]}"
}
while [ ${#queue[@]} -gt 0 ]; do
  page=${queue[0]}
  queue=("${queue[@]:1}")
  [ -z "${seen[$page]-}" ] || continue
  seen[$page]=yes
  while IFS=: read -r line target; do
    case $target in http*) continue ;; esac
    links=$((links + 1))
    anchor=
    [[ $target != *#* ]] || anchor=${target#*#}
    file=${target%%#*}
    to=$page
    if [ -n "$file" ]; then
      folder=
      [[ $page != */* ]] || folder=${page%/*}/
      resolve "$folder$file"
    fi
    if [ ! -e "$to" ]; then
      echo "$page:$line: dead link '$target'; no file $to"
      failed=1
      continue
    fi
    [ -f "$to" ] && [[ $to == *.md ]] || continue
    if [ -n "$anchor" ]; then
      [ -n "${anchors[$to]-}" ] || anchors[$to]=$'\n'$(headings "$to")$'\n'
      [[ ${anchors[$to]} == *$'\n'"$anchor"$'\n'* ]] ||
        { echo "$page:$line: dead link '$target'; $to has no such heading"; failed=1; }
    fi
    # README and its like are no way from the index to a page.
    case $page in docs/*) [[ $to != docs/* ]] || queue+=("$to") ;; esac
  done < <(links_of "$page")
done
while read -r page; do
  [ -n "${seen[$page]-}" ] || { echo "$page: not reached from docs/index.md; link to it"; failed=1; }
done < <(find -L docs -name '*.md' | sort)
[ "$links" -gt 100 ] || { echo "only $links links were found"; failed=1; }
exit $failed
