# Doxygen input filter: formulas as GitHub writes them, $...$ and ```math blocks,
# become Doxygen's @f$...@f$ and @f[...@f]. Code spans and other code blocks stay.

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
          gsub(/\$/, "@f$", parts[i])
        }
      line = line (i > 1 ? "`" : "") parts[i]
    }
  print line
}
