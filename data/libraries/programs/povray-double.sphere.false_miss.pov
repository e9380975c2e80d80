// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: sphere 0x0p+0 0x1p+0 0x0p+0 0x1p-17 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 131071 / 131072 = 0.99999237060546875
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = sphere { <0.0, 1.0, 0.0>, 7.62939453125e-06 }
#declare P = trace(Shape, <0.0, 0.0, 0.0>, <0.0, 1.0, 0.0>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
