// build: povray +IFILE +W1 +H1 -D -F -GA
// says any: "If the ray hits the specified object, this function returns the coordinate where the ray intersected the object. If not, it returns <0,0,0>." (reference 3.7, 3.3.1.8.3 Vector Functions, trace)
// says false_hit: "Checking the normal vector for <0,0,0> is the only reliable way to determine whether an intersection has actually occurred" (the same)
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cone { <@ax@, @ay@, @az@>, @r@, <@bx@, @by@, @bz@>, 0 open }
#declare P = trace(Shape, <@ox@, @oy@, @oz@>, <@dx@, @dy@, @dz@>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
