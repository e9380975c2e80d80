// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: capped_cone 0x1.1920efbap+0 0x0p+0 0x1p+1 0x1.1920efbap+0 0x0p+0 0x0p+0 0x1.6a543p-1 ray 0x1.1ee72d4p+1 0x0p+0 -0x1.4a9068p-1 -0x1.4cb8101bf518p-3 0x0p+0 0x1.f932b745ef70cp-1 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 4318509156176161144832 / 1610630840787165934339 = 2.6812532374368107437...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cone { <1.098158820066601, 0.0, 2.0>, 0.7076735496520996, <1.098158820066601, 0.0, 0.0>, 0 }
#declare P = trace(Shape, <2.241429954767227, 0.0, -0.6456329822540283>, <-0.1624604471713944, 0.0, 0.9867150566931016>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
