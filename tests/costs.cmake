# Read by ctest: what takes minutes under sanitizers begins first.
set_tests_properties(FeedHold.AtAnyMillisecondOfALineLosesNothing PROPERTIES COST 120)
