# The top of the tree holds what everyone looks for there, and nothing else.
cd "$STRAD_SOURCE_DIR"

if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  entries=$(git ls-files | cut -d/ -f1 | sort -u)
else
  entries=$(ls | grep -v '^build')
fi
expected='CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE Makefile README.md lib man scenes tests tools'
diff <(grep -v '^\.' <<<"$entries") <(tr ' ' '\n' <<<"$expected")
