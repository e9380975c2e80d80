// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: cone 0x1.c9f4c8p+1 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1.a8c56p+0 ray 0x1.10fc2d4p+4 0x1.f51b7p+2 0x1.678p+0 -0x1.a13331c09a57p-1 -0x1.25998be0b93cp-1 -0x1.5b8c5ffd2918p-4 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 16.547693647447996199...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cone { <3.57778263092041, 0.0, 0.0>, 1.659261703491211, <0.0, 0.0, 0.0>, 0 open }
#declare P = trace(Shape, <17.061566591262817, 7.829799652099609, 1.404296875>, <-0.8148437068568182, -0.5734370910473601, -0.08485066886584569>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
