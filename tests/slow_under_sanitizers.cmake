# Read by ctest of the sanitized build: these take 10 s to minutes there even with few trials, so
# only toolchain/prove.sh runs them under sanitizers, as it does all test programs but those of
# planner and firmware. toolchain/test.sh runs them in release.
foreach(test
    CrowdedOutline.MeetsNoMoreOfItselfHoweverCloselyItIsDrawn
    ArcTable.TakesNoMoreArcsThanTheBestFitWithKinks
    ArcSplineFit.StaysWithinItsToleranceBothWaysAndHasNoKink
    RandomChains.StayWithinBothTolerancesBothWays
    RandomRows.HaveAtEachPlaceThePowerThatTheProgramHasThere
    PixelRow.MayBeWrittenWithThreeDecimalsInAnyDirection
    Operator.MayHoldOrOverrideAtEveryHundredthOfASecondOfAJob
    RandomArcs.StayOnTheExactCurveWithinTheirLimits
    JerkLimitedTime.OnAFinerGridIsTheSame
    JerkReference.EnclosesRandomPrograms
    PeerJobs.TakeNoLongerThanOptimalMotionAndOnePercent
    MachineMotionTest.EndsEveryWayAtRest
    Reentry.CompletesAPartWhoseSenderWasLostAtEveryHundredthOfASecond
    host-sim.cut_command
    host-sim.cut_safety
    host-sim.cut_identity
    host-sim.cut_output
    host-sim.order_command)
  set_tests_properties(${test} PROPERTIES LABELS prove)
endforeach()
