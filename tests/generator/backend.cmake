# What is tested without C++: checks, passes and printers on netlists made by hand or by chance.
unit_test(backend_print hlsgen_lib)
unit_test(backend_pass hlsgen_lib)
