# The library throws and returns; only tools print and choose an exit status.
cd "$STRAD_SOURCE_DIR"

banned='\b(cout|cerr|clog) *<<|[^a-z_](printf|puts|putchar|perror|exit|abort|_exit|quick_exit) *\(|fprintf\( *(stdout|stderr)'
if grep -rnE "$banned" lib --include='*.cpp' --include='*.h'; then
  exit 1
fi
