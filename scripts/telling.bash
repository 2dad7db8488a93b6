# Sourced by the scripts that install and build: they tell what they do in lines of their own, and how far they are in one line that
# renews itself on a terminal; where the output goes elsewhere, in a plain line for each tenth.

if [[ -t 1 ]]; then telling_on_terminal=true; else telling_on_terminal=false; fi
telling_open=false  # the line that renews itself stands without an end
telling_tenth=-1    # that was told last
telling_text=""     # that stands there

# A line of its own.
tell() {
  tell_end
  echo "washfsi: $1"
}

# tell_progress DONE TOTAL TEXT
tell_progress() {
  if $telling_on_terminal; then
    if [[ $3 == "$telling_text" ]]; then return; fi
    telling_text=$3
    printf '\rwashfsi: %s\033[K' "$3"
    telling_open=true
    return
  fi
  local tenth=$((10 * $1 / ($2 > 0 ? $2 : 1)))
  if [[ $tenth -ne $telling_tenth ]]; then
    telling_tenth=$tenth
    echo "washfsi: $3"
  fi
}

# Ends the line that renews itself.
tell_end() {
  if $telling_open; then echo; fi
  telling_open=false
  telling_tenth=-1
  telling_text=""
}
