#pragma once

#include "SideRequest.h"

#include <string>

namespace crossfield
{
/// Requests that prescribe one thing for a side.
inline SideRequest CountOf(const std::string& side, int count)
{
  SideRequest request;
  request.side = side;
  request.count = count;
  return request;
}

inline SideRequest SizeOf(const std::string& side, double size)
{
  SideRequest request;
  request.side = side;
  request.size = size;
  return request;
}

inline SideRequest GradingOf(const std::string& side, const Progression& progression)
{
  SideRequest request;
  request.side = side;
  request.progression = progression;
  return request;
}

inline SideRequest LayerOf(const std::string& side, double first, double growth = 1.2, int rows = 0)
{
  SideRequest request;
  request.side = side;
  request.layer = LayerPrescription{ side, first, growth, rows };
  return request;
}

inline SideRequest PartnerOf(const std::string& side, const std::string& partner)
{
  SideRequest request;
  request.side = side;
  request.partner = partner;
  return request;
}

inline SideRequest CurveOf(const std::string& side, CurveDeclaration::Kind kind)
{
  SideRequest request;
  request.side = side;
  request.curve = kind;
  return request;
}
}
