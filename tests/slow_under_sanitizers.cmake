# Read by ctest of the sanitized build: these take 10 s to a minute there even with few trials, so
# only toolchain/prove.sh runs them under sanitizers. toolchain/test.sh runs them in release.
foreach(test
    CutCurves.KeepHalfAKerfAwayWithinTheTolerance
    CutPlan.NeverCutsIntoAPart
    OrderChoice.IsNoWorseThanTheNearestNeighbour
    CutEdges.StayThereWhereTheControllerFindsTheWayBesideThem
    CutEdges.OfCurvesAreWithinTheToleranceAndFiveMicrometres
    CutEdges.StayThereUnderFeedOverrides
    CutEdges.KeepTheirSizeWithLoopsAndDwellsAtCorners
    CrowdedOutline.MeetsNoMoreOfItselfHoweverCloselyItIsDrawn
    ArcTable.TakesNoMoreArcsThanTheBestFitWithKinks
    ArcSplineFit.StaysWithinItsToleranceBothWaysAndHasNoKink
    RandomChains.StayWithinBothTolerancesBothWays
    RandomRows.HaveAtEachPlaceThePowerThatTheProgramHasThere
    PixelRow.MayBeWrittenWithThreeDecimalsInAnyDirection
    Operator.MayHoldOrOverrideAtEveryHundredthOfASecondOfAJob)
  set_tests_properties(${test} PROPERTIES LABELS prove)
endforeach()
