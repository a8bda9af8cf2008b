// Names a page that is not there, for the negative control of named_files.sh.
//
// Doc: docs/no_such_page.md   Test: tests/tools/named_files.sh
