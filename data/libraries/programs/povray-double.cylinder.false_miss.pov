// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: cylinder 0x1.e8e4p+0 0x1.bdd6p+0 0x1.d7cp-2 0x0p+0 0x0p+0 0x0p+0 0x1.b45p+1 ray 0x1.33p-3 -0x1.7dp-1 -0x1.bbf4p+1 0x1.7471194c70fcp-1 0x1.53a4b9e382fecp-1 0x1.6768b988774cp-3 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 2.6843665373455306903...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cylinder { <1.90972900390625, 1.741546630859375, 0.460693359375>, <0.0, 0.0, 0.0>, 3.40869140625 open }
#declare P = trace(Shape, <0.14990234375, -0.744140625, -3.4683837890625>, <0.7274253755390347, 0.6633661356186145, 0.17549271533690636>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
