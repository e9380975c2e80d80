// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: capped_cylinder -0x1.17affbd6ead75p+25 0x1.8e609fc72dddbp+21 0x1.73edd88dd16c3p+24 -0x1.17affc11db75cp+25 0x1.8e609baec0d1dp+21 0x1.73edd7c801048p+24 0x1.99cf9dcc2052bp-1 ray -0x1.17affbc439b08p+25 0x1.8e60b0c72f1dep+21 0x1.73edda33b73a4p+24 -0x1.1968dcd4d1c05p-4 -0x1.ad6120c70d1f6p-1 -0x1.14a8978b7c9c9p-1 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 23487452117058740834795520 / 8496207967888544194491929 = 2.7644629469793666283...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cylinder { <-36659191.67904178, 3263507.972255451, 24374744.553976785>, <-36659192.13950989, 3263507.4603287117, 24374743.781265527>, 0.8004121123960081 }
#declare P = trace(Shape, <-36659191.53301054, 3263510.0972578367, 24374746.20201458>, <-0.06870352041470092, -0.8386316531164641, -0.5403487546703271>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
