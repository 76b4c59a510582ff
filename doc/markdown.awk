# Doxygen input filter: Markdown as GitHub reads it becomes Markdown as Doxygen
# reads it.
#   formulas  $...$ and ```math blocks become @f$...@f$ and @f[...@f]; code spans
#             and other code blocks stay
#   links     to ../prm lead to the copy of prm beside the pages
#   quotes    `code with '` would be taken for a quotation: ``code with '``
#   pages     the title of doc/model.md gets the name {#model}, in every version
#             of Doxygen; that of tests/README.md the name of its folder

FNR == 1 && /^# / && FILENAME ~ /\.md$/ {
  n = split(FILENAME, path, "/")
  name = path[n]
  sub(/\.md$/, "", name)
  if (name == "README")
    name = path[n - 1]
  sub(/\r?$/, " {#" tolower(name) "}")
}

/^[ \t]*```/ {
  if (in_math)
    { print "@f]"; in_math = 0; next }
  if ($1 == "```math")
    { print "@f["; in_math = 1; next }
  in_code = !in_code
}

in_math || in_code { print; next }

{
  n_parts = split($0, parts, "`")
  line = ""
  for (i = 1; i <= n_parts; ++i)
    {
      if (i % 2 == 1)
        {
          gsub(/[\\@]f\$/, "$", parts[i])
          gsub(/\\\$/, "\001", parts[i])
          gsub(/\$/, "@f$", parts[i])
          gsub("\001", "\\$", parts[i])
          gsub(/\]\(\.\.\/prm\//, "](prm/", parts[i])
        }
      else if (i < n_parts && parts[i] ~ /'/)
        parts[i] = "`" parts[i] "`"
      line = line (i > 1 ? "`" : "") parts[i]
    }
  print line
}
